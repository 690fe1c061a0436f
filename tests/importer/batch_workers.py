# SPDX-License-Identifier: MIT
"""A thousand units that a scheduler runs on two workers, of which one is killed in the middle: batch_workers.py SINEW parallel|slurm

Slurm's daemons are started on the loopback interface, with folders and ports of their own, and stopped afterwards. The report must be
the one of a batch in one process, to the byte. Exit status 77 where the scheduler is not installed."""
import contextlib
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

UNITS, SHARDS, WORKERS = 1000, 8, 2
MODEL = '{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "n%d", "translation": [%d, 0, 0]}]}'
REPORTS = ("report.json", "report.csv", "report.html")


def skip(missing):
    print(f"{missing} is not installed: nothing was run")
    sys.exit(77)


def wait_for(what, condition, seconds=120):
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, f"{what} within {seconds} s"
        time.sleep(0.05)
    return found


def output(*words, **options):
    return subprocess.run(words, check=True, capture_output=True, text=True, **options).stdout


class Batch:
    def __init__(self, sinew, folder):
        self.sinew, self.folder, self.models = sinew, folder, folder / "models"
        self.models.mkdir()
        for i in range(UNITS):
            # One unit in a hundred is broken: failures are part of the report.
            (self.models / f"m{i:04}.gltf").write_text("{" if i % 100 == 7 else MODEL % (i, i))

    def words(self, out, *more):
        return [self.sinew, "batch", "models", "--do", "info {in}", "-o", out, *more]

    def run(self, out, *more):
        return subprocess.run(self.words(out, *more), cwd=self.folder, capture_output=True, text=True, check=False)

    def done(self, out):
        """How many units have a result."""
        units = self.folder / out / "units"
        return sum(not name.startswith(".") for name in os.listdir(units)) if units.is_dir() else 0

    def emit(self, out, kind):
        return output(*self.words(out, "--emit", kind, "--shards", str(SHARDS)), cwd=self.folder)

    def check_same(self, out, times_before):
        """The report is that of one process, and no result was made twice after the kill."""
        assert self.run(out, "--merge").returncode == 1, "ten units are broken"
        assert self.run("alone", "--jobs", str(WORKERS)).returncode == 1
        for name in REPORTS:
            one, other = ((self.folder / folder / name).read_bytes() for folder in ("alone", out))
            assert one == other, f"{name} differs"
        for name, when in times_before.items():
            assert (self.folder / out / "units" / name).stat().st_mtime_ns == when, f"{name} was done twice"

    def times(self, out):
        return {entry.name: entry.stat().st_mtime_ns for entry in os.scandir(self.folder / out / "units") if not entry.name.startswith(".")}


def shards_running(folder, out):
    """Process numbers of the shards that run now. A unit that was forked a moment ago still has its shard's words: it is left out."""
    parents = {}
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            words = (entry / "cmdline").read_bytes().split(b"\0")
            # The scheduler's own shell has all of them in one word.
            if b"batch" in words and out.encode() in words and b"--shard" in words and os.readlink(entry / "cwd") == str(folder):
                parents[int(entry.name)] = int((entry / "stat").read_text().rsplit(")", 1)[1].split()[1])
    return [pid for pid, parent in parents.items() if parent not in parents]


def kill_one_in_the_middle(batch, out):
    # Not a multiple of what a shard holds: the workers are inside shards then.
    wait_for("a third of the units", lambda: batch.done(out) >= UNITS // 3)
    pid = wait_for("a worker", lambda: shards_running(batch.folder, out))[0]
    os.kill(pid, signal.SIGKILL)
    print(f"killed a worker when {batch.done(out)} units were done")


def run_parallel(batch):
    if shutil.which("parallel") is None or "GNU" not in output("parallel", "--version"):
        skip("GNU parallel")
    lines = batch.emit("out", "parallel")
    log = batch.folder / "joblog"
    words = ["parallel", "--will-cite", "-j", str(WORKERS), "--joblog", log]
    first = subprocess.Popen(words, cwd=batch.folder, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True)
    first.stdin.write(lines)
    first.stdin.close()
    kill_one_in_the_middle(batch, "out")
    first.wait(timeout=300)
    before = batch.times("out")
    assert len(before) < UNITS, "nothing was left to resume"
    subprocess.run([*words, "--resume-failed"], cwd=batch.folder, input=lines, text=True, capture_output=True, timeout=300, check=False)
    batch.check_same("out", before)


SLURM_CONF = """ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={workers} State=UNKNOWN
PartitionName=night Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]


@contextlib.contextmanager
def slurm(folder):
    """A controller and a node of this machine; yields the environment in which its commands find them."""
    folder.mkdir(mode=0o755)
    for name in ("state", "spool"):
        (folder / name).mkdir()
    key = folder / "munge.key"
    key.write_bytes(os.urandom(1024))
    key.chmod(0o400)
    host = socket.gethostname().split(".")[0]
    (folder / "slurm.conf").write_text(SLURM_CONF.format(host=host, folder=folder, ports=free_ports(2), workers=WORKERS))
    environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"))
    daemons = [["munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket", f"--pid-file={folder}/munge.pid",
                f"--seed-file={folder}/munge.seed", f"--log-file={folder}/munge.log"], ["slurmctld", "-D", "-c"], ["slurmd", "-D", "-c", "-N", host]]
    path = environment["PATH"] + ":/usr/sbin:/sbin"
    started = []
    try:
        for words in daemons:
            log = open(folder / f"{words[0]}.out", "wb")
            started.append(subprocess.Popen([shutil.which(words[0], path=path), *words[1:]], env=environment, stdout=log, stderr=log))
            if words[0] == "munged":
                wait_for("munge's socket", (folder / "munge.socket").exists, 20)

        def state():
            assert all(one.poll() is None for one in started), "".join(f.read_text(errors="replace") for f in folder.glob("*.[ol][uo][tg]"))
            return subprocess.run(["sinfo", "-h", "-o", "%T"], env=environment, capture_output=True, text=True, check=False).stdout.strip()

        wait_for("an idle node", lambda: state() == "idle", 60)
        yield environment
    finally:
        for one in reversed(started):
            one.terminate()
        for one in reversed(started):
            try:
                one.wait(timeout=20)
            except subprocess.TimeoutExpired:
                one.kill()


def run_slurm(batch):
    for tool in ("munged", "slurmctld", "slurmd", "sbatch"):
        if shutil.which(tool, path=os.environ["PATH"] + ":/usr/sbin:/sbin") is None:
            skip("Slurm")
    if os.geteuid() != 0:
        print("Slurm's daemons are started as root only: nothing was run")
        sys.exit(77)
    script = batch.folder / "night.sh"
    script.write_text(batch.emit("out", "slurm"))
    with slurm(batch.folder / "slurm") as environment:
        def submit():
            return output("sbatch", "--parsable", script, cwd=batch.folder, env=environment).strip()

        def left():
            return output("squeue", "-h", env=environment).strip()

        submit()
        kill_one_in_the_middle(batch, "out")
        wait_for("the end of the jobs", lambda: not left(), 300)
        before = batch.times("out")
        assert len(before) < UNITS, "nothing was left to resume"
        submit()  # the same script resumes
        wait_for("the end of the jobs", lambda: not left(), 300)
    batch.check_same("out", before)


def main():
    sinew, scheduler = sys.argv[1:]
    os.environ["PATH"] = f"{pathlib.Path(sinew).parent}:{os.environ['PATH']}"
    with tempfile.TemporaryDirectory() as name:
        batch = Batch(sinew, pathlib.Path(name).resolve())
        start = time.monotonic()
        {"parallel": run_parallel, "slurm": run_slurm}[scheduler](batch)
        print(f"{UNITS} units in {SHARDS} shards by {scheduler}, and again in one process, took {time.monotonic() - start:.0f} s")


main()
