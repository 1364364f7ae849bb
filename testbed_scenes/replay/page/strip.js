// A chart over all steps: what stays the same is drawn once, the mark of the present step each time.

class Strip {
  constructor(canvas) {
    this.canvas = canvas;
    this.backdrop = null;
  }

  // To be called when the data or the colours have changed.
  forget() { this.backdrop = null; }

  // The size in CSS pixels; 0 where the canvas is hidden.
  begin() {
    const ratio = Math.min(2, window.devicePixelRatio || 1), width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (this.width !== width || this.height !== height || this.ratio !== ratio) this.forget();
    Object.assign(this, { width, height, ratio });
    return this;
  }

  draw(drawBackdrop, drawMark) {
    if (!this.backdrop) {
      this.canvas.width = Math.max(1, this.width * this.ratio);
      this.canvas.height = Math.max(1, this.height * this.ratio);
      this.backdrop = document.createElement("canvas");
      this.backdrop.width = this.canvas.width;
      this.backdrop.height = this.canvas.height;
      const g = this.backdrop.getContext("2d");
      g.scale(this.ratio, this.ratio);
      drawBackdrop(g);
    }
    const g = this.canvas.getContext("2d");
    g.setTransform(1, 0, 0, 1, 0, 0);
    g.clearRect(0, 0, this.canvas.width, this.canvas.height);
    g.drawImage(this.backdrop, 0, 0);
    g.scale(this.ratio, this.ratio);
    drawMark(g);
  }
}
