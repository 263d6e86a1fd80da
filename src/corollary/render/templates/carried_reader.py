"""Reading and judging in the browser: takes the modules that it is given, and answers two questions as JSON."""

import base64
import json
import sys
import types
from collections.abc import Callable
from functools import lru_cache
from importlib import import_module
from typing import Any

AT_HAND = 8  # exercises


def begin(carried: str) -> Callable[[str, str, str, str], str]:
    given = json.loads(carried)
    loader = types.ModuleType("corollary_carried")
    exec(given["loader"], loader.__dict__)
    sys.meta_path.insert(0, loader.__dict__["Carried"](given["modules"]))
    table, messages, offline, verdicts, texts = (
        import_module(f"corollary.{name}")
        for name in (
            "units.unit_table",
            "messages",
            "practice.offline",
            "answers.verdict",
            "grading.verdict_text",
        )
    )
    for row in given["units"]:
        table.register(*row)
    for domain, text in given["catalogues"].items():
        messages.carry(domain, given["language"], base64.b64decode(text))
    messages.speak(given["language"])
    for name in given["entries"]:
        import_module(name)

    @lru_cache(AT_HAND)
    def exercise(key: str) -> Any:
        return offline.Offline(json.loads(key))

    def answered(ask: str, key: str, part: str, answer: str) -> str:
        if ask == "read":
            found = exercise(key).preview(part, json.loads(answer))
            return json.dumps({"ok": found.ok, "text": found.text})
        verdict = exercise(key).verdict(part, json.loads(answer))
        return json.dumps(
            {"word": verdicts.word(verdict), "text": texts.sentence(verdict), "known": offline.known(verdict)}
        )

    return answered
