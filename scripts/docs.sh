#!/usr/bin/env bash
# Builds the documentation as a static site that needs no network and no server, and checks its links and pictures.
#
#   scripts/docs.sh [FOLDER]    the site's folder, which is replaced; default: build/site
#
# If scripts/portable.sh wasm has made build/portable/overbend.html, or OVERBEND_HTML names this file, the tutorials run in
# the reader's browser.
set -euo pipefail
root="$(cd "$(dirname "$0")/.." && pwd)"
site="$(realpath -m "${1:-$root/build/site}")"

bash "$root/scripts/install.sh" docs

if [[ -e "$site" && -n "$(ls -A "$site")" && ! -f "$site/searchindex.js" ]]; then
  echo "scripts/docs.sh: $site is not a site made by this script; give another folder or remove it" >&2
  exit 2
fi

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# Debian's own Python, which has Sphinx; the one first on the PATH may be another.
export PYTHONDONTWRITEBYTECODE=1
program="${OVERBEND_HTML:-$root/build/portable/overbend.html}"
with_program=()
[[ -f "$program" ]] && with_program=(with-program)
/usr/bin/python3 "$root/tools/site/sources.py" "$work/pages" "${with_program[@]}"
/usr/bin/python3 -m sphinx -b html -W --keep-going -q -j auto \
  -c "$root/tools/site" -d "$work/doctrees" "$work/pages" "$work/site"
[[ -f "$program" ]] && cp "$program" "$work/site/overbend.html"
rm -f "$work/site/.buildinfo" "$work/site/objects.inv"
/usr/bin/python3 "$root/tools/site/check_links.py" "$work/site" "$root/docs"

rm -rf "$site"
mkdir -p "$(dirname "$site")"
mv "$work/site" "$site"
echo "Documentation: $site/index.html"
