# completion_test.bash PROGRAM: drives the completion that the program prints for bash.
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/../../../scenes" || exit 2
script=$("$1" completion bash) || exit 2
eval "$script"
failures=0

# expect WANTED WORD...: what the last of the words on a line is completed to, in the order offered.
expect() {
  local wanted=$1
  shift
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _plimsoll
  if [[ ${COMPREPLY[*]} != "$wanted" ]]; then
    printf '%s\n  gives    %s\n  expected %s\n' "$*" "${COMPREPLY[*]}" "$wanted"
    failures=$((failures + 1))
  fi
}

# expect_all_options COMMAND: every long option of the command's help is offered.
expect_all_options() {
  local option
  COMP_WORDS=(plimsoll "$1" --) COMP_CWORD=2 COMPREPLY=()
  _plimsoll
  for option in $("$program" "$1" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    if [[ " ${COMPREPLY[*]} " != *" $option "* ]]; then
      printf '%s: %s is not offered\n' "$1" "$option"
      failures=$((failures + 1))
    fi
  done
}

program=$1
commands=$("$program" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]\+\) .*/\1/p' | tr '\n' ' ')
[[ $commands == "run new check "* ]] || { echo "no commands in the help"; exit 1; }
expect "${commands% }" plimsoll ''
for command in $commands; do expect_all_options "$command"; done

expect 'run render report radiation rao' plimsoll r
expect '--help --version' plimsoll --
expect 'teapot_drop.yaml' plimsoll run teapot_d
expect 'teapot_drop.yaml' plimsoll run --quiet teapot_d
expect 'hinged_gate.yaml' plimsoll check teapot_drop.yaml hing
expect 'meshes' plimsoll run --out mes
expect 'meshes' plimsoll run --out = mes
expect '' plimsoll run --threads ''
expect 'galerkin' plimsoll addedmass --method g
expect 'bash zsh' plimsoll completion ''
expect '' plimsoll nothing ''

# The shell hands words over apart at their equals signs, and takes what stands behind the last.
expect 'gravity= ground.' plimsoll run --set gr
expect 'bodies[0].' plimsoll run --set bod
expect 'bodies[0].' plimsoll run --set 'bodies['
expect 'bodies[crate].linear_velocity= bodies[crate].lock=' plimsoll run --set 'bodies[crate].l'
expect 'bodies[a].forces[0].sine.phase_deg=' plimsoll run --set 'bodies[a].forces[0].sine.p'
expect 'render.cameras.NAME.' plimsoll run --set render.cameras.
expect 'render.cameras.bow.' plimsoll run --set render.cameras.bow
expect 'render.cameras.bow.fov_deg= render.cameras.bow.follow=' plimsoll run --set render.cameras.bow.fo
expect 'render.cameras.NAME.' plimsoll run --set render.cameras.NAME
expect 'meshes' plimsoll run --video mes
expect 'hydro.added_mass= hydro.added_mass.' plimsoll probe --set hydro.added
expect 'none deep' plimsoll run --set hydro.added_mass = ''
expect 'thesis' plimsoll run --set = 'bodies[0].hydro.viscous_drag' = t
expect '' plimsoll run --set bodies[0].density = ''

COMP_WORDBREAKS=' '
expect 'log.forces=true' plimsoll run --set log.forces=t

exit $((failures > 0))
