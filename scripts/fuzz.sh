#!/usr/bin/env bash
# Runs every fuzz target of build/fuzz for its share of the time. What it finds it leaves in build/fuzz/findings;
# of a sweep or a ray also a moment-*.json for `surefoot replay`: what broke a promise, or was never answered.
#
#     scripts/fuzz.sh [SECONDS]                  all targets together take this long (default: 600)
#     build/fuzz/fuzz/fuzz_sweep FINDING         one finding again
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[[ ${1:-} != --help && ${1:-} != -h ]] || { sed -n '2,6s/^# \{0,1\}//p' "$0"; exit 0; }
seconds=${1:-600}

targets=()
while IFS= read -r target; do targets+=("$target"); done < <(find build/fuzz/fuzz -maxdepth 1 -type f -name 'fuzz_*' -executable | sort)
((${#targets[@]})) || { echo "no fuzz targets: first cmake --preset fuzz && cmake --build build/fuzz"; exit 1; }
share=$((seconds / ${#targets[@]}))

failed=()
export SUREFOOT_FUZZ_FINDINGS=build/fuzz/findings
for target in "${targets[@]}"; do
    name=$(basename "$target")
    mkdir -p "build/fuzz/corpus/$name" build/fuzz/findings
    seeds=()
    [[ -d fuzz/seeds/$name ]] && seeds+=("fuzz/seeds/$name")
    echo "== $name for $share s"
    "$target" -max_total_time="$share" -timeout=10 -rss_limit_mb=4096 -print_final_stats=1 -verbosity=0 \
        -artifact_prefix="build/fuzz/findings/$name-" "build/fuzz/corpus/$name" "${seeds[@]}" || failed+=("$name")
done
# A sanitizer's report or a time-out ends a target before it can save what it asked: once more, with every question written
# down before it is asked.
for name in "${failed[@]}"; do
    for finding in build/fuzz/findings/"$name"-{crash,timeout,oom}-*; do
        [[ -f $finding ]] || continue
        SUREFOOT_FUZZ_UNDER_WAY="build/fuzz/findings/moment-of-${finding##*/}.json" \
            "build/fuzz/fuzz/$name" -timeout=60 -rss_limit_mb=4096 "$finding" > /dev/null 2>&1 || true
    done
done
((${#failed[@]} == 0)) || { echo "failed: ${failed[*]}; the inputs are in build/fuzz/findings"; exit 1; }
