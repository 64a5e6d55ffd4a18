#!/usr/bin/env bash
# FreeCAD without a screen: it builds three models by its Python interface, writes the decks, starts
# what it takes for ccx, and reads the results back. Here that is slideline, under a link named ccx,
# and then, where it is installed, ccx itself: the lines RESULT of both are to be compared by eye
# (docs/ccx.md). Needs Debian's freecad-python3 (0.20; 270 MB). Usage: benches/drop-in/freecad.sh [FOLDER]
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
folder="${1:-$(mktemp -d)}"
program="${SLIDELINE:-$here/../../target/release/slideline}"
freecad="${FREECAD:-/usr/lib/freecad/bin/freecadcmd-python3}"

[ -x "$program" ] || { echo "build slideline first, or name it: SLIDELINE=..." >&2; exit 1; }
[ -x "$freecad" ] || { echo "no FreeCAD: apt-get install freecad-python3" >&2; exit 1; }

mkdir -p "$folder/path"
ln -sf "$(realpath "$program")" "$folder/path/ccx"

# who: a folder that PATH begins with; kind of model
solve() {
    local work="$folder/$1-$3"
    rm -rf "$work"
    mkdir -p "$work/home" "$work/job"
    HOME="$work/home" PATH="$2$PATH" QT_QPA_PLATFORM=offscreen FOLDER="$work/job" KIND="$3" \
        timeout 300 "$freecad" "$here/freecad_model.py" > "$work/log" 2>&1 || {
        tail -20 "$work/log" >&2
        return 1
    }
    grep -q "^EXIT 0" "$work/log" && grep -q "STDERR ''" "$work/log"
    echo "$1 $3 $(grep -o 'RESULT.*' "$work/log")"
}

failed=0
for kind in solid tied contact; do
    solve slideline "$folder/path:" "$kind" || failed=1
    if command -v ccx > /dev/null; then
        solve ccx "" "$kind" || true
    fi
done
echo "files are in $folder"
exit "$failed"
