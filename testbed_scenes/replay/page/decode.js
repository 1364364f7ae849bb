// From the text in the page to columns of numbers: the encoding is described in encoding.h.

async function inflate(bytes) {
  if (typeof DecompressionStream === "undefined")
    throw new Error("this browser cannot unpack the replay (it lacks DecompressionStream)");
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function fromBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

function decodeColumn(bytes, at, size, count, order, width) {
  const values = new (width === 1 ? Int8Array : width === 2 ? Int16Array : Int32Array)(count);
  const end = at + size;
  let last = 0, beforeLast = 0;
  for (let i = 0; i < count; ++i) {
    let coded = 0, shift = 0, byte;
    do {
      byte = bytes[at++];
      coded |= (byte & 127) << shift;
      shift += 7;
    } while (byte > 127);
    const difference = (coded >>> 1) ^ -(coded & 1);
    const value = order === 0 ? difference : order === 1 ? (last + difference) | 0
      : (2 * last - beforeLast + difference) | 0;
    beforeLast = last;
    last = value;
    values[i] = value;
  }
  if (at !== end) throw new Error("the replay's data is damaged");
  return values;
}

// { name: typed array }
function decodeColumns(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const magic = String.fromCharCode(...bytes.subarray(0, 4));
  if (magic !== "BMRR" || view.getUint32(4, true) !== 1) throw new Error("the replay's data is of another version");
  const heads = [];
  let at = 12;
  for (let left = view.getUint32(8, true); left > 0; --left) {
    const length = bytes[at];
    const name = String.fromCharCode(...bytes.subarray(at + 1, at + 1 + length));
    at += 1 + length;
    heads.push({ name, order: bytes[at], width: bytes[at + 1], count: view.getUint32(at + 2, true), size: view.getUint32(at + 6, true) });
    at += 10;
  }
  const columns = {};
  for (const head of heads) {
    columns[head.name] = decodeColumn(bytes, at, head.size, head.count, head.order, head.width);
    at += head.size;
  }
  return columns;
}

async function decodePage() {
  const data = document.getElementById("data");
  const columns = decodeColumns(await inflate(fromBase64(data.textContent.trim())));
  data.textContent = ""; // megabytes that nobody needs again
  return columns;
}
