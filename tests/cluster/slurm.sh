# SPDX-License-Identifier: GPL-3.0-or-later
#
# A cluster of one node, as root, without systemd: munged, slurmctld and slurmd on ports of its own.
. "$(dirname "$0")/common.sh"

need sbatch slurmctld slurmd munged mungekey runuser
[ "$(id -u)" = 0 ] || skip "only root can start slurmd"
begin

started=""
stop_services() {
    for service in $started; do
        kill "$service" 2>/dev/null || :
        while kill -0 "$service" 2>/dev/null; do sleep 0.05; done
    done
    [ -z "${munge:-}" ] || rm -rf "$munge"
}

# munged is picky about who owns what.
munge=$(runuser -u munge -- mktemp -d)
chmod 755 "$munge"
runuser -u munge -- mungekey --create --keyfile="$munge/key" >munge.log 2>&1
runuser -u munge -- munged --foreground --key-file="$munge/key" --socket="$munge/socket" \
    --pid-file="$munge/pid" --log-file="$munge/log" --seed-file="$munge/seed" >>munge.log 2>&1 &
started=$!
while [ ! -S "$munge/socket" ]; do
    kill -0 "$started"
    sleep 0.05
done

host=$(hostname -s)
port=$((20000 + $$ % 10000 * 3))
mkdir state spool
cat >slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=1
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$work/slurm.conf"
slurmctld -c -D >slurmctld.log 2>&1 &
started="$! $started"
slurmd -D >slurmd.log 2>&1 &
started="$! $started"
until sinfo --noheader --format=%T 2>/dev/null | grep -q idle; do
    for service in $started; do
        kill -0 "$service"
    done
    sleep 0.1
done

recipe Slurm >shards.sh
grep -q '^#SBATCH --array=0-199' shards.sh
# --wait looks every few seconds only.
submit() {
    sbatch --quiet --array=0-3 --cpus-per-task=1 --output=%a.out shards.sh
    while [ -n "$(squeue --noheader)" ]; do sleep 0.1; done
}
submit
expect_one_run
# A task that was lost, and one that was cut off: the same once more.
rm results/shard-0002-of-0004.ndjson
: >results/shard-0001-of-0004.ndjson
refuses ncsim merge results/
submit
expect_one_run
grep -q 'programs were verified before' 0.out
grep -q 'programs verified' 2.out
