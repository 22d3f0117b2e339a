# Packages of a Debian release, sources or binaries, by lists of their own: the machine's are left as they are. Sourced by
# libraries.sh and pack_wheel.sh, with $work set to the working folder.

use_release() {  # RELEASE TYPES: sets apt for it; TYPES deb or deb-src
  local folder="$work/apt-$1" mirror
  apt=(apt-get -q -o "Dir::State::Lists=$folder/lists" -o "Dir::State::status=$folder/status" -o "Dir::Cache=$folder/cache"
       -o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=- -o APT::Sandbox::User= -o Acquire::Retries=3
       -o APT::Install-Recommends=false)
  [[ -f "$folder/listed" ]] && return
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial"
  touch "$folder/status"
  mirror="$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -m 1 '/debian/\?$' || true)"
  echo "$2 ${mirror:-http://deb.debian.org/debian} $1 main" >"$folder/sources.list"
  "${apt[@]}" update >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  touch "$folder/listed"
}

unpack_packages() {  # RELEASE FOLDER PACKAGE...: unpacks them with all they need, without running their scripts
  local release="$1" folder="$2"
  shift 2
  [[ -f "$folder/.unpacked" && "$(cat "$folder/.unpacked")" == "$*" ]] && return
  use_release "$release" deb
  rm -rf "$folder"
  mkdir -p "$folder"
  "${apt[@]}" -y --download-only install "$@" >"$work/log" 2>&1 || {
    echo "$0: packages of Debian $release cannot be downloaded: $*" >&2
    tail -n 3 "$work/log" >&2
    exit 1
  }
  for package in "$work/apt-$release"/cache/archives/*.deb; do dpkg-deb --fsys-tarfile "$package" | tar -x --keep-directory-symlink -C "$folder"; done
  rm "$work/apt-$release"/cache/archives/*.deb
  # The linker follows links that begin at the root into the machine's own libraries.
  find "$folder" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
    ln -sfnr "$folder$(readlink "$link")" "$link"
  done
  echo "$*" >"$folder/.unpacked"
}
