"""Headless Chromium by its debugging pipe (Chrome DevTools Protocol), without other packages."""
import json
import os
import select
import subprocess
import tempfile
import time

FLAGS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--remote-debugging-pipe", "--no-first-run",
         "--disable-background-networking", "--window-size=1200,1000", "about:blank"]


class Browser:
    """one browser with one page; errors and fetched: of the page that is open"""

    def __init__(self, more=()):
        self.folder = tempfile.TemporaryDirectory()
        read, self.write_end = os.pipe()
        self.read_end, write = os.pipe()

        def hand_over():
            os.dup2(read, 13)
            os.dup2(write, 14)
            os.dup2(13, 3)
            os.dup2(14, 4)

        command = ["chromium", "--user-data-dir=" + self.folder.name] + list(more) + FLAGS
        self.process = subprocess.Popen(command, preexec_fn=hand_over, close_fds=False,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        os.close(read)
        os.close(write)
        self.number, self.text, self.session = 0, b"", None
        self.errors, self.fetched, self.loaded = [], [], False
        target = [t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page"]
        self.session = self.call("Target.attachToTarget", targetId=target[0]["targetId"],
                                 flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(30)
        os.close(self.write_end)
        os.close(self.read_end)
        try:
            self.folder.cleanup()
        except OSError:   # a process of the browser still wrote there
            pass

    def call(self, method, **arguments):
        """the result of a command"""
        self.number += 1
        message = {"id": self.number, "method": method, "params": arguments}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.write_end, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.message(60)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError("%s: %s" % (method, answer["error"]["message"]))
                return answer["result"]

    def message(self, seconds):
        """the next message; what is told of the page is noted"""
        end = time.time() + seconds
        while b"\0" not in self.text:
            if not select.select([self.read_end], [], [], max(0, end - time.time()))[0]:
                raise TimeoutError("Chromium: no answer within %d s" % seconds)
            part = os.read(self.read_end, 1 << 20)
            if not part:
                raise RuntimeError("Chromium has ended")
            self.text += part
        one, self.text = self.text.split(b"\0", 1)
        one = json.loads(one)
        self.note(one.get("method"), one.get("params", {}))
        return one

    def note(self, event, what):
        """errors, requests, the end of loading"""
        if event == "Runtime.exceptionThrown":
            self.errors.append(what["exceptionDetails"]["text"])
        elif event == "Runtime.consoleAPICalled" and what["type"] in ("error", "warning"):
            self.errors.append(str(what["args"]))
        elif event == "Log.entryAdded" and what["entry"]["level"] in ("error", "warning"):
            self.errors.append(what["entry"]["text"])
        elif event == "Network.requestWillBeSent":
            self.fetched.append(what["request"]["url"])
        elif event == "Page.loadEventFired":
            self.loaded = True

    def open(self, url):
        """a page, when it has been loaded and two frames were drawn"""
        self.errors, self.fetched, self.loaded = [], [], False
        self.call("Page.navigate", url=url)
        while not self.loaded:
            self.message(60)
        self.value("new Promise(f => requestAnimationFrame(() => requestAnimationFrame(f)))")
        self.fetched = [u for u in self.fetched if u != url and not u.startswith("data:")]

    def value(self, expression):
        """what an expression of JavaScript gives in the page"""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError("%s: %s" % (expression, answer["exceptionDetails"]["text"]))
        return answer["result"].get("value")

    def key(self, name, code):
        """a key pressed and let go, as from a keyboard"""
        for kind in ("rawKeyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=name, code=name,
                      windowsVirtualKeyCode=code, nativeVirtualKeyCode=code)

    def picture(self, element):
        """PNG of an element, base64"""
        x, y, width, height = self.value(
            "(() => { const e = document.querySelector('%s'); e.scrollIntoView();"
            "const b = e.getBoundingClientRect(); return [b.x + scrollX, b.y + scrollY, b.width,"
            "b.height]; })()" % element)
        return self.call("Page.captureScreenshot", format="png", captureBeyondViewport=True,
                         clip={"x": x, "y": y, "width": width, "height": height,
                               "scale": 1})["data"]
