# SPDX-License-Identifier: MIT
"""A headless Chromium for tests: started or explained, never skipped."""

import shutil
import sys
import time

# A bound for what hangs: on a machine with other work everything takes long.
PATIENCE_SECONDS = 900


def fail_to_start(why):
    sys.exit(f"the browser cannot start: {why}\n"
             "needed (Debian): apt-get install chromium chromium-driver python3-selenium")


try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError as error:
    fail_to_start(error)


class Browser:
    """A window of a given size; `driver` is Selenium's."""

    def __init__(self, width=1280, height=800):
        chromium, chromedriver = shutil.which("chromium"), shutil.which("chromedriver")
        if not chromium or not chromedriver:
            fail_to_start("chromium or chromedriver is not installed")
        options = Options()
        options.binary_location = chromium
        # As root in a container there is neither a sandbox nor a GPU nor a large /dev/shm. (A test chooses faster than
        # hands do: Chromium would hold back the page's address.)
        for switch in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                       "--disable-ipc-flooding-protection",
                       f"--window-size={width},{height}"):
            options.add_argument(switch)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        try:
            self.driver = webdriver.Chrome(service=Service(chromedriver), options=options)
        except WebDriverException as error:
            fail_to_start(error)
        self.driver.set_script_timeout(PATIENCE_SECONDS)
        self.resize(width, height)

    def close(self):
        self.driver.quit()

    def resize(self, width, height, touch=False):
        """The page's own size, in CSS pixels."""
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                    {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": touch})

    def prefer(self, **features):
        """Media features, with _ for -: prefers_color_scheme="dark"."""
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": name.replace("_", "-"), "value": value} for name, value in features.items()]})

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def open(self, path):
        self.driver.get(f"file://{path}")

    def wait(self, condition, seconds=PATIENCE_SECONDS):
        """Until the JavaScript expression is true; whether it came to be."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.run(f"return {condition}"):
                return True
            time.sleep(0.02)
        return False

    def settle(self):
        """Until what was asked for has been drawn."""
        self.driver.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));")

    def errors(self):
        """What the console has said since the last call, but for notes."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]

    def colours(self, selector):
        """How many different colours a screenshot shows where the element is."""
        box = self.run("const b = document.querySelector(arguments[0]).getBoundingClientRect();"
                       "return [b.left, b.top, b.width, b.height].map(Math.floor)", selector)
        return self.driver.execute_async_script("""
            const [picture, [left, top, width, height], done] = arguments, image = new Image();
            image.onload = () => {
              const canvas = document.createElement("canvas");
              canvas.width = image.width; canvas.height = image.height;
              const g = canvas.getContext("2d");
              g.drawImage(image, 0, 0);
              done(new Set(new Uint32Array(g.getImageData(left, top, width, height).data.buffer)).size);
            };
            image.src = "data:image/png;base64," + picture;""", self.driver.get_screenshot_as_base64(), box)
