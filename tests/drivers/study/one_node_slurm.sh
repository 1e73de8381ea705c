#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# A Slurm of one node in a folder: `one_node_slurm.sh FOLDER PORT` starts it, `one_node_slurm.sh FOLDER stop` ends it.
# Exit status 77 and a reason where that cannot be done here. FOLDER/slurm.conf is what SLURM_CONF must name.
set -u
folder=$1
cannot() {
  echo "$1"
  "$0" "$folder" stop
  exit 77
}
stop() {
  for name in slurmd slurmctld munged; do
    [ -s "$folder/$name.pid" ] && kill "$(cat "$folder/$name.pid")" 2>/dev/null
  done
  for attempt in $(seq 50); do # until their numbers are gone
    alive=0
    for name in slurmd slurmctld munged; do
      [ -s "$folder/$name.pid" ] && kill -0 "$(cat "$folder/$name.pid")" 2>/dev/null && alive=1
    done
    [ $alive = 0 ] && return
    sleep 0.1
  done
}
if [ "$2" = stop ]; then
  stop
  exit 0
fi
port=$2
PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch sinfo; do
  command -v $program >/dev/null || { echo "no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "slurmd wants to be root"; exit 77; }

mkdir -p "$folder/state" "$folder/spool" "$folder/munge"
chmod 700 "$folder/munge"
head -c 1024 /dev/urandom >"$folder/munge/key"
chmod 400 "$folder/munge/key"
munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" >/dev/null 2>&1 || cannot "munged does not start"

host=$(hostname -s)
cat >"$folder/slurm.conf" <<END
ClusterName=assay
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,builtin_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$folder/slurm.conf
slurmctld -c >/dev/null 2>&1 || cannot "slurmctld does not start"
slurmd -c >/dev/null 2>&1 || cannot "slurmd does not start"
for attempt in $(seq 150); do
  [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && exit 0
  sleep 0.1
done
cannot "the node is not idle: $(sinfo -h -o %T 2>&1)"
