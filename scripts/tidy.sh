#!/usr/bin/env bash
# Runs clang-tidy, as .clang-tidy says, over the sources of the clang build; every finding is an error.
#
#     scripts/tidy.sh              all sources of build/clang-release
#     scripts/tidy.sh FILE...      these alone
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[[ ${1:-} != --help && ${1:-} != -h ]] || { sed -n '2,5s/^# \{0,1\}//p' "$0"; exit 0; }
database=build/clang-release
[[ -f $database/compile_commands.json ]] || { echo "first: cmake --preset clang-release"; exit 1; }

files=("$@")
if ((${#files[@]} == 0)); then
    while IFS= read -r file; do files+=("$file"); done < <(
        python3 -c 'import json, sys; print("\n".join(sorted({e["file"] for e in json.load(open(sys.argv[1]))})))' \
            "$database/compile_commands.json" | grep -v '/build/')
fi
echo "clang-tidy: ${#files[@]} files"
printf '%s\0' "${files[@]}" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 -p "$database" --quiet --warnings-as-errors='*'
