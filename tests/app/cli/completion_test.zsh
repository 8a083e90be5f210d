# completion_test.zsh PROGRAM: types into a shell that has the completion that the program prints.
zmodload zsh/zpty || exit 77
cd ${0:A:h}/../../../scenes || exit 2
folder=$(mktemp -d) || exit 2
trap 'rm -rf $folder' EXIT
$1 completion zsh > $folder/_plimsoll || exit 2

# In the shell, Return shows what is on the line and empties it.
cat > $folder/.zshrc <<'RC'
PS1= PROMPT= TERM=dumb
unsetopt prompt_cr prompt_sp beep
fpath=($ZDOTDIR $fpath)
autoload -Uz compinit && compinit -u -d $ZDOTDIR/dump
show() { print -r -- "<<$BUFFER>>"; BUFFER=; }
zle -N show
bindkey '^M' show
print READY
RC
export ZDOTDIR=$folder
zpty -b shell zsh -i
zpty -r -m shell said '*READY*' || exit 2
failures=0

# expect WANTED TYPED: what Tab makes of a line.
expect() {
  local said
  zpty -w -n shell "$2"$'\t\r'
  zpty -r -m shell said '*<<*>>*'
  said=${${said##*<<}%%>>*}
  if [[ $said != $1 ]]; then
    print -r -- "$2 gives $said, expected $1"
    failures=$((failures + 1))
  fi
}

expect 'plimsoll hydrostatics ' 'plimsoll hydros'
expect 'plimsoll run --no-render ' 'plimsoll run --no-r'
expect 'plimsoll run teapot_drop.yaml ' 'plimsoll run teapot_d'
expect 'plimsoll run --out meshes/' 'plimsoll run --out mes'
expect 'plimsoll check a.yaml hinged_gate.yaml ' 'plimsoll check a.yaml hing'
expect 'plimsoll run --set render.cameras.bow.orbit=' 'plimsoll run --set render.cameras.bow.o'
expect 'plimsoll run --video meshes/' 'plimsoll run --video mes'
expect 'plimsoll addedmass --method galerkin ' 'plimsoll addedmass --method g'
expect 'plimsoll run --set gravity=' 'plimsoll run --set grav'
expect 'plimsoll run --set bodies\[0\].' 'plimsoll run --set bod'
expect 'plimsoll run --set bodies\[a\].density=' 'plimsoll run --set bodies\[a\].den'
expect 'plimsoll run --set integrator.method=ode ' 'plimsoll run --set integrator.method=o'
exit $((failures > 0))
