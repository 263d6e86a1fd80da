"""Outputs of a cell in their order, as nbformat 4 has them, and no more of them than allowed."""

import base64


def clean(text):
    """Text that can be written down: no half surrogate."""
    return str.encode(text, "utf-8", "replace").decode("utf-8")


class Outputs:
    """The outputs of the cell that runs; streams, results, displays and errors all end up here."""

    def __init__(self, most_bytes):
        self.most_bytes = most_bytes
        self.start()

    def start(self):
        self.items = []
        self.left = self.most_bytes
        self.full = False
        self.places = {}

    def stream(self, name, text):
        if self.full:
            return
        text = self._room_for(clean(text))
        if not text:
            return
        last = self.items[-1] if self.items else {}
        if last.get("output_type") == "stream" and last["name"] == name:
            last["parts"].append(text)
        else:
            self.items.append({"output_type": "stream", "name": name, "parts": [text]})

    def display(self, data, count=None, place=None, update=False):
        """A bundle of mime types; with `count` it is the cell's result, Out[count]."""
        bundle = {}
        for mime, content in data.items():
            if type(content) is bytes:
                content = base64.b64encode(content).decode()
            if type(content) is str and type(mime) is str:
                bundle[clean(mime)] = clean(content)
        size = sum(len(content) for content in bundle.values())
        if size > self.left:
            bundle = {"text/plain": f"[{size} characters of output left out]"}
        self.left -= min(size, self.left)
        if update:
            if place in self.places:
                self.places[place]["data"] = bundle
            return
        item = {"output_type": "display_data", "data": bundle, "metadata": {}}
        if count is not None:
            item |= {"output_type": "execute_result", "execution_count": count}
        if place is not None:
            self.places[place] = item
        self._add(item)

    def error(self, name, value, lines):
        name, value = clean(name)[:200], clean(value)[:2000]
        lines = [clean(line)[:2000] for line in lines[-40:]]
        # The error is added even when the cell has shown too much already: it is what the student must read.
        self.items.append({"output_type": "error", "ename": name, "evalue": value, "traceback": lines})

    def clear(self):
        self.items = []

    def _add(self, item):
        if len(self.items) < 500:
            self.items.append(item)

    def _room_for(self, text):
        if len(text.encode()) <= self.left:
            self.left -= len(text.encode())
            return text
        text, self.left = text.encode()[: self.left].decode("utf-8", "ignore"), 0
        self.full = True
        return f"{text}\n[the output is cut here: a cell shows at most {self.most_bytes} bytes]\n"

    def as_list(self):
        return [
            {**{key: value for key, value in each.items() if key != "parts"}, "text": "".join(each["parts"])}
            if each["output_type"] == "stream"
            else each
            for each in list(self.items)
        ]


class OutputStream:
    """Stands for standard output or standard error."""

    encoding = "utf-8"
    errors = "replace"
    closed = False

    def __init__(self, name, outputs):
        self.name = f"<{name}>"
        self._name = name
        self._outputs = outputs

    def write(self, text):
        if not isinstance(text, str):
            raise TypeError(f"write() argument must be str, not {type(text).__name__}")
        self._outputs.stream(self._name, text)
        return len(text)

    def writelines(self, lines):
        for line in lines:
            self.write(line)

    def flush(self):
        return None

    def isatty(self):
        return False

    def writable(self):
        return True

    def readable(self):
        return False

    def seekable(self):
        return False

    def fileno(self):
        return 1 if self._name == "stdout" else 2

    def close(self):
        return None

    def reconfigure(self, **_):
        return None
