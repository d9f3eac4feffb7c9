#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# check_translations.sh ROOT: every text of the front-end has a finished French translation, and so have nearly
# all labels of parameters (plugins gain some all the time; those of others are never here).
set -euo pipefail
root=$1
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cp -- "$root"/resources/i18n/*.ts "$folder"
"$root/packaging/update-translations" "$folder"
python3 - "$folder" <<'PYTHON'
import sys
import xml.etree.ElementTree as tree
bad = []
labels = [0, 0]
for language in ("fr", "en"):
    for context in tree.parse(f"{sys.argv[1]}/wcam_{language}.ts").getroot().findall("context"):
        name = context.find("name").text
        for message in context.findall("message"):
            translation = message.find("translation")
            forms = translation.findall("numerusform")
            texts = [form.text for form in forms] if forms else [translation.text]
            finished = translation.get("type") != "unfinished" and all(texts)
            if name == "engine":
                labels[0 if finished else 1] += 1
            elif not finished:
                bad.append(f"{language} {name}: {message.find('source').text!r}")
            # Arguments must not get lost.
            source = message.find("source").text
            for argument in ("%1", "%2", "%3", "%4", "%L2", "%L3"):
                if finished and any((argument in source) != (argument in text) for text in texts):
                    bad.append(f"{language} {name}: {source!r} and its translation differ in {argument}")
if labels[1] > 0.25 * sum(labels):
    bad.append(f"{labels[1]} of {sum(labels)} labels of parameters are not translated")
print("\n".join(bad) or "all texts are translated")
sys.exit(1 if bad else 0)
PYTHON
