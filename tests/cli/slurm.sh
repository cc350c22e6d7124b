#!/usr/bin/env bash
# docs/grade.sbatch on a cluster of one node, which dies midway:
#
#   tests/cli/slurm.sh SHADOWLAB
#
# Starts a munged, a slurmctld and a slurmd of its own, kills the node and all that runs on it, starts
# it anew, and wants the results of a run that nothing happened to. 77: skipped.
set -euo pipefail
home=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
SHADOWLAB=$(realpath "$1")
export SHADOWLAB
for program in munged slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || { echo "skipped: there is no $program"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: only root may be a node"; exit 77; }
PATH=$PATH:/usr/sbin

work=$(mktemp -d)
export SLURM_CONF=$work/slurm.conf
# Whatever was started with this configuration, the programs of jobs among it.
of_the_node() {
  local environment process
  while IFS= read -r environment; do
    process=${environment%/environ}
    case $(tr '\0' ' ' <"$process/cmdline") in
      slurmd* | slurmstepd* | *slurm_script* | *"$SHADOWLAB grade"*) echo "${process#/proc/}" ;;
    esac
  done < <(grep -slzxF "SLURM_CONF=$SLURM_CONF" /proc/[0-9]*/environ) 2>/dev/null || true
}
kill_node() { of_the_node | xargs -r kill -KILL 2>/dev/null || true; }
controller='' munge=''
end() {
  kill_node
  [ -z "$controller" ] || kill -KILL "$controller" 2>/dev/null || true
  [ -z "$munge" ] || kill "$munge" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap end EXIT
fail() {
  echo "$1" >&2
  tail -n 30 "$work"/*.log "$work"/out/*.log >&2 2>/dev/null || true
  exit 1
}
# until_so SECONDS COMMAND...
until_so() {
  local until=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $until ] || fail "never so: $*"
    sleep 0.1
  done
}

# A lab whose pictures take a moment, and a class.
mkdir -p "$work"/{lab/mistakes,in,out,state,spool,munge}
recipe() {
  cat <<LUA
local recipe = { params = { red = param.number(1, 0, 1) } }
function recipe.draw(r)
  for i = 1, 1e7 do end
  gl.ClearColor($1, 0, 0, 1)
  gl.Clear(gl.COLOR_BUFFER_BIT)
end
return recipe
LUA
}
cat >"$work/lab/lab.lua" <<'LUA'
return { title = "Paint", points = 4, size = {16, 16}, cases = {
  { name = "quarter", points = 1, set = { red = 0.25 } },
  { name = "any", points = 3, set = { red = random.number(0.6, 0.9) } } } }
LUA
recipe r.params.red >"$work/lab/solution.lua"
recipe 0 >"$work/lab/template.lua"
for i in $(seq 24); do recipe "$([ $((i % 3)) -eq 0 ] && echo 0.25 || echo r.params.red)" >"$work/in/s$i.lua"; done
"$SHADOWLAB" grade "$work/lab" "$work/in" -o "$work/whole" --jobs 2 >/dev/null || [ $? -eq 1 ]

# Ports that nobody has.
read -r port_of_controller port_of_node < <(python3 - <<'PYTHON'
import socket
sockets = [socket.socket() for _ in range(2)]
for one in sockets: one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in sockets))
PYTHON
)
node=$(hostname -s)
cat >"$SLURM_CONF" <<CONF
ClusterName=shadowlab
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$port_of_controller
SlurmdPort=$port_of_node
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SchedulerParameters=sched_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SlurmdTimeout=3
SlurmdParameters=config_overrides
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
dd if=/dev/urandom of="$work/munge/key" bs=128 count=1 2>/dev/null
chmod 700 "$work" "$work/munge"
chmod 400 "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
  --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" \
  --num-threads=2 2>"$work/munge.log" &
munge=$!
until_so 10 test -S "$work/munge/socket"
slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
controller=$!
start_node() {
  slurmd -D -f "$SLURM_CONF" >/dev/null 2>&1 &
  disown
}
state_is() { [[ $(sinfo -h -o %T) == *"$1"* ]]; }
start_node
until_so 30 state_is idle

cd "$work"
sbatch -Q --array=1-2 --cpus-per-task=1 --mem-per-cpu=0 --output="$work/out/%a.log" \
  "$home/docs/grade.sbatch" "$work/lab" "$work/in" "$work/out"
sbatch -Q --dependency=singleton --mem-per-cpu=0 --output="$work/out/merge.log" \
  "$home/docs/grade.sbatch" --merge "$work/out"

results() { find "$work/out" -path '*/shard-*/result.json' | wc -l; }
some() { [ "$(results)" -ge 3 ]; }
until_so 60 some
kill_node
before=$(results)
[ "$before" -lt 24 ] || fail "all was done before the node could die"
until_so 60 state_is down
start_node
done_with_all() { [ -z "$(squeue -h)" ]; }
until_so 120 done_with_all

cmp "$work/whole/scores.csv" "$work/out/graded/scores.csv" || fail "the results are not the same"
[ "$(results)" -eq 24 ] || fail "$(results) results of 24 submissions"
echo "The node died after $before of 24 results; the rest came after it was back."
