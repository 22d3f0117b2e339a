#!/usr/bin/env bash
# Starts a Slurm of one node on this machine, as root and without systemd, with all its state under DIR.
#
#   eval "$(tests/cluster/slurm-up.sh DIR)"      sets SLURM_CONF for the shell
#
# Needs the Debian packages slurm-wlm and munge. Listens on 127.0.0.1 only.
set -euo pipefail
dir=$(realpath -m "${1:?a folder for the state of Slurm}")
host=$(hostname -s)
memory=$(($(awk '/MemTotal/{print $2}' /proc/meminfo) / 1024 - 512))
mkdir -p "$dir"/{etc,state,spool,log,munge}
# The daemon of munge refuses folders that others may write to.
chmod 755 "$dir" "$dir"/log && chmod 700 "$dir"/munge

# A key and socket of its own: a munge of the system is left alone.
if [ ! -s "$dir/munge/key" ]; then
  dd if=/dev/urandom of="$dir/munge/key" bs=1024 count=1 status=none
  chmod 400 "$dir/munge/key"
fi
/usr/sbin/munged --force --socket="$dir/munge/sock" --key-file="$dir/munge/key" --pid-file="$dir/munge/pid" \
  --log-file="$dir/log/munged.log" --seed-file="$dir/munge/seed" >/dev/null 2>"$dir/log/munged.err"

cat >"$dir/etc/slurm.conf" <<CONF
ClusterName=overbend
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${SLURMCTLD_PORT:-16817}
SlurmdPort=${SLURMD_PORT:-16818}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$dir/munge/sock
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/log/slurmctld.log
SlurmdLogFile=$dir/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
MpiDefault=none
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
ReturnToService=2
MaxArraySize=20001
MaxJobCount=50000
SwitchType=switch/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$memory State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$dir/etc/slurm.conf"
/usr/sbin/slurmctld -c # forgets an old state
/usr/sbin/slurmd
for _ in $(seq 100); do
  if [ "$(sinfo -h -o %T 2>/dev/null)" = idle ]; then
    echo "export SLURM_CONF=$SLURM_CONF"
    exit 0
  fi
  sleep 0.1
done
echo "the node of Slurm did not come up" >&2
sinfo >&2 || true
tail -5 "$dir"/log/*.log >&2
exit 1
