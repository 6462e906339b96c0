# Sourced by scripts that run one case of a test: goes to an empty folder of its own, which is removed
# at the end. The script ends with `exit "$failed"`.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failed=0

fail() {
    echo "FAIL: $*"
    failed=1
}
