#!/usr/bin/env bash
# Packs the program for 64-bit ARM:  pack_aarch64.sh BUILD OUTPUT
set -euo pipefail
STRIP=aarch64-linux-gnu-strip exec bash "$(dirname "$0")/pack_linux.sh" "$1" "$2" -aarch64
