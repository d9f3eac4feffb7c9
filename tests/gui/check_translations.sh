#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_translations.sh ROOT: every text of the front-end, of the engine and of the plugins has a finished French
# translation with the same places, and no finding or error is put together out of pieces of a sentence.
set -euo pipefail
root=$1
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cp -- "$root"/resources/i18n/*.ts "$folder"
"$root/packaging/update-translations" "$folder"
python3 - "$folder" <<'PYTHON'
import re
import sys
import xml.etree.ElementTree as tree
bad = []
for language in ("fr", "en"):
    for context in tree.parse(f"{sys.argv[1]}/wcam_{language}.ts").getroot().findall("context"):
        name = context.find("name").text
        for message in context.findall("message"):
            source = message.find("source").text
            translation = message.find("translation")
            forms = translation.findall("numerusform")
            texts = [form.text for form in forms] if forms else [translation.text]
            if translation.get("type") == "unfinished" or not all(texts):
                bad.append(f"{language} {name}: {source!r} is not translated")
                continue
            # Arguments must not get lost.
            places = sorted(set(re.findall("%L?[1-9]", source)))
            if any(sorted(set(re.findall("%L?[1-9]", text))) != places for text in texts):
                bad.append(f"{language} {name}: {source!r} and its translation differ in their places")
print("\n".join(bad) or "all texts are translated")
sys.exit(1 if bad else 0)
PYTHON

"$root/packaging/engine-texts" --check
# The rule sees what it is for.
cat >"$folder/glued.cpp" <<'CPP'
[[noreturn]] void refuse(const Text& why) { throw Error(ErrorCode::JobFailed, why); }
void a(const std::string& name) { throw Error(ErrorCode::JobFailed, "the part '" + name + "' is missing"); }
void b(const std::string& name) { throw Error(ErrorCode::JobFailed, "wrong", {}, one ? "use " + name : "use none"); }
void c(const std::string& name) { refuse("the part " + name + " is missing"); }
void d(const std::string& name) { context.add({Severity::Warning, "x.y", "the part " + name + " is odd", {}, {}, {}}); }
void e(Diagnostic& finding) { finding.message += " in a travel move"; }
Text f(const std::string& name) { return "the part " + name; }
void g(const std::string& name) { refuse(text("the part %1 is %2", {name})); }
void h(const std::string& name) { refuse(text("the part %1", {name + " of the cell"})); }
void right(const std::string& name) { refuse(text("the part '%1' is missing", {name})); }
CPP
if told=$("$root/packaging/engine-texts" --check "$folder/glued.cpp"); then
  echo "texts that are put together with + are not seen"
  exit 1
fi
for line in 2 3 4 5 6 7 8 9; do
  if ! grep -q "glued.cpp:$line:" <<<"$told"; then
    echo "line $line of the sample is not seen: $told"
    exit 1
  fi
done
if grep -q "glued.cpp:10:" <<<"$told"; then
  echo "a right text is refused: $told"
  exit 1
fi
