"""A Slurm of one node, for tests: its daemons, configuration and state lie in one folder and end with it."""

import os
import pwd
import shutil
import socket
import subprocess
import time
from pathlib import Path

PATIENCE_S = 180
# cred_expire: a requeued task waits that long
CONFIGURATION = """ClusterName=nicol
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=2
ReturnToService=2
KillWait=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(condition, what, details=lambda: "", hopeless=lambda: False):
    end = time.monotonic() + PATIENCE_S
    while not condition():
        if hopeless() or time.monotonic() > end:
            raise TimeoutError(f"{what} has not come\n{details()}")
        time.sleep(0.1)


class Slurm:
    def __init__(self, folder, cpus=2):
        self.folder = Path(folder)
        self.daemons = []
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.folder.chmod(0o711)  # munge wants its socket to be reached
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=self.folder, host=host, cpus=cpus, user=pwd.getpwuid(os.getuid()).pw_name,
            controller_port=free_port(), node_port=free_port()))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)

    def __enter__(self):
        try:
            # --force: its socket lies in a folder for temporary files
            self.start("munged", "--foreground", "--force", f"--key-file={self.folder}/munge.key", f"--socket={self.folder}/munge.socket",
                       f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log", f"--seed-file={self.folder}/munged.seed")
            wait_for((self.folder / "munge.socket").exists, "munge's socket", self.logs, self.has_lost_one)
            self.start("slurmctld", "-D")
            self.start("slurmd", "-D")
            wait_for(lambda: self.run("sinfo", "-h", "-o", "%t").strip() == "idle", "an idle node", self.logs, self.has_lost_one)
        except BaseException:
            self.__exit__()
            raise
        return self

    def start(self, name, *arguments):
        path = shutil.which(name, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")
        if not path:
            raise FileNotFoundError(f"{name} is not installed")
        log = open(self.folder / f"{name}.out", "wb")  # pylint: disable=consider-using-with
        self.daemons.append(subprocess.Popen([path, *arguments], stdout=log, stderr=log, env=self.environment, start_new_session=True))
        log.close()

    def has_lost_one(self):
        return any(daemon.poll() is not None for daemon in self.daemons)

    def __exit__(self, *_):
        if len(self.daemons) > 1:
            self.run("scancel", "--full", "--signal=KILL", f"--user={pwd.getpwuid(os.getuid()).pw_name}")
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def run(self, *command):
        """Its standard output; what goes wrong is for those who wait to see."""
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, timeout=60).stdout

    def submit(self, *arguments, **environment):
        """The job's number."""
        result = subprocess.run(["sbatch", "--parsable", *map(str, arguments)], env={**self.environment, **environment}, cwd=self.folder,
                                capture_output=True, text=True, check=False, timeout=60)
        if result.returncode:
            raise RuntimeError(f"sbatch: {result.stderr}\n{self.logs()}")
        return result.stdout.strip()

    def state(self, job):
        """RUNNING, COMPLETED, ... of a job or of a task (12_3); the states of all tasks of an array."""
        told = self.run("scontrol", "-o", "show", "job", job)
        states = [word[len("JobState="):] for word in told.split() if word.startswith("JobState=")]
        return " ".join(states)

    def logs(self):
        return "\n".join(f"== {path.name}\n{path.read_text(errors='replace')[-2000:]}" for path in
                         sorted([*self.folder.glob("*.out"), *self.folder.glob("*.log")]))
