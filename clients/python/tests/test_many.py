"""Many jobs: over executors, into studies, on and on."""

from __future__ import annotations

import contextlib
import dataclasses
import json
import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from conftest import roller

import brinell
from brinell import Client
from brinell._core import Core, Emit, Send
from brinell._course import Course, Outcome
from brinell._records import Files, Records, digest_of
from brinell._workers import _here, known, wanted

PROGRAM = os.environ["BRINELL_PROGRAM"]
SMALL = {"analysis": "plane_strain", "elements_per_half_width": 5}


def small(count: int, **more: Any) -> list[Any]:
    """Jobs of milliseconds, each another."""
    forces = np.linspace(100, 600, count)
    return [brinell.job(roller(), roller(), force=force, **SMALL, **more) for force in forces]


def long() -> Any:
    """A job of minutes."""
    forces = np.linspace(300, 600, 400)
    return brinell.job(
        roller(), roller(), analysis="plane_strain", forces=forces, elements_per_half_width=40
    )


def by_solve(job: Any) -> dict[str, Any]:
    """The result by `brinell solve`."""
    done = subprocess.run(
        [PROGRAM, "solve", "-", "--format", "json"],
        input=json.dumps(brinell.document(job)).encode(),
        capture_output=True,
        check=True,
    )
    return untimed(json.loads(done.stdout))


def untimed(value: Any) -> Any:
    """The same without the times that it took."""
    if isinstance(value, list):
        return [untimed(one) for one in value]
    if isinstance(value, dict):
        times = ("timings_ms", "elapsed_ms")
        return {name: untimed(one) for name, one in value.items() if name not in times}
    return value


def processes(count: int) -> Executor:
    return ProcessPoolExecutor(count, mp_context=get_context("spawn"))


def loky(count: int) -> Executor:
    from loky import ProcessPoolExecutor as Loky

    executor: Executor = Loky(count)
    return executor


@pytest.mark.parametrize("make", [processes, loky])
def test_each_process_of_an_executor_solves(make: Callable[[int], Executor]) -> None:
    jobs = [*small(8), {"analysis": "plane_strain"}, small(1, fields=True)[0]]
    with make(2) as executor:
        pairs = list(brinell.map(jobs, executor=executor, ordered=True))
        here = {executor.submit(server_here).result() for _ in range(8)}
        table = brinell.sweep(jobs[0], {"/load/force": [200, 100]}, executor=executor)
    assert [job for job, _ in pairs] == jobs
    *results, bad, with_fields = [result for _, result in pairs]
    assert [untimed(result.data) for result in results] == [by_solve(job) for job in jobs[:8]]
    servers, logs = zip(*here, strict=True)
    assert isinstance(bad.error, brinell.InvalidJob)
    assert with_fields.fields().lower is not None
    assert table["force"].tolist() == pytest.approx([200, 100])
    assert 1 <= len(servers) <= 2
    until(lambda: not any(map(alive, servers)))
    assert not any(map(os.path.exists, logs))


def server_here() -> tuple[int, Path]:
    server = _here()._server
    assert server is not None
    return server.pid, server.log


def alive(pid: int) -> bool:
    try:
        stat = Path(f"/proc/{pid}/stat").read_text()
    except FileNotFoundError:
        return False
    return stat.rsplit(")", 1)[1].split()[0] not in "ZX"


def until(is_so: Callable[[], bool], seconds: float = 60) -> None:
    end = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < end


@pytest.fixture
def cluster() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None
    ) as cluster:
        yield cluster


def test_a_dask_cluster_loses_a_worker(cluster: Any) -> None:
    from distributed import Client as Dask

    jobs = small(60)
    seen = []
    with Dask(cluster) as dask:
        for job, result in brinell.map(jobs, executor=dask.get_executor()):
            seen.append((jobs.index(job), result))
            if len(seen) == 20:
                os.kill(next(iter(cluster.workers.values())).pid, signal.SIGKILL)
    assert sorted(place for place, _ in seen) == list(range(60))
    assert all(result.converged for _, result in seen)
    for place, result in seen[::12]:
        assert untimed(result.data) == by_solve(jobs[place])


@pytest.mark.parametrize("make", [processes, loky])
def test_a_loop_that_is_left_stops_its_jobs(make: Callable[[int], Executor]) -> None:
    with make(1) as executor:
        for _ in brinell.map([*small(1), long()], executor=executor):
            # The long job is under way, or on its way.
            break
        (_, result) = next(brinell.map(small(1), executor=executor))
        assert result.converged
        states = executor.submit(states_here).result()
    assert "running" not in states
    assert "succeeded" in states


def states_here() -> list[str]:
    client = _here()
    jobs = client._run(client._core.json("GET", "/v1/jobs"))["jobs"]
    return [job["status"] for job in jobs]


def test_a_long_job_does_not_hold_up_the_others() -> None:
    with Client(workers=2) as client:
        jobs = [long(), *small(30)]
        for number, (job, _) in enumerate(client.map(jobs, in_flight=8), 1):
            assert job is not jobs[0]
            if number == 30:
                break


def test_answers_come_in_order_and_are_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("brinell._course.HELD", 4)
    course = Course(small(12), ordered=True, in_flight=3)
    first, *others = course.take()
    emitted = []
    while others:
        course.finish(others.pop(), Outcome({}, "", {}))
        emitted += list(course.answers())
        others += course.take()
    assert emitted == []
    course.finish(first, Outcome({}, "", {}))
    emitted += [place for place, *_ in course.answers()]
    assert emitted == list(range(len(emitted)))
    assert 4 <= len(emitted) <= 7


def test_a_result_that_cannot_be_had_is_asked_for_again() -> None:
    done = {"id": "7", "done": True, "status": "succeeded", "has_result": True}
    handed_in = {"job": {"id": "7", "done": False}}
    jobs = [
        handed_in,
        {"status": 503, "problem": {"title": "busy"}},
        # Removed to make room; so it is to HEAD.
        {"status": 404, "problem": {"title": "no such job"}},
        handed_in,
        {"job": {**done, "result": {"steps": []}}},
    ]
    said = iter([httpx.Response(200, json={"jobs": [job]}) for job in jobs])
    flow = Core(0).map(Course(small(1), ordered=False, in_flight=1, retries=1), "")
    emitted = []
    with contextlib.suppress(StopIteration):
        effect = next(flow)
        while True:
            if isinstance(effect, Emit):
                emitted.append(effect.value)
            is_post = isinstance(effect, Send) and effect.method == "POST"
            effect = flow.send(next(said) if is_post else httpx.Response(404))
    ((_, _, outcome),) = emitted
    assert outcome.report == {"steps": []}


class Losing(Executor):
    """Loses results: a number of them, then none."""

    def __init__(self, losses: int) -> None:
        self.losses = losses

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        if self.losses > 0:
            self.losses -= 1
            future.set_exception(TypeError("cannot unpack"))
        else:
            future.set_result(Outcome({}, "", {"steps": []}))
        return future


@pytest.mark.parametrize("losses", [1, 2])
def test_a_result_that_an_executor_loses_is_solved_once_more(losses: int) -> None:
    ((_, result),) = brinell.map(small(1), executor=Losing(losses))
    assert isinstance(result.error, brinell.JobFailed) is (losses == 2)


@pytest.mark.parametrize("replayed", [False, True])
def test_a_run_that_is_left_cancels_its_own_jobs(replayed: bool) -> None:
    flow = Core(0).map(Course(small(1), ordered=False, in_flight=1), "")
    next(flow)
    item = {"job": {"id": "7", "done": False}, "replayed": replayed}
    flow.send(httpx.Response(200, json={"jobs": [item]}))
    cancelled = []
    with contextlib.suppress(KeyboardInterrupt):
        effect = flow.throw(KeyboardInterrupt())
        while True:
            assert isinstance(effect, Send)
            cancelled.append(effect.body)
            effect = flow.send(httpx.Response(200, json={}))
    assert cancelled == ([] if replayed else [b'{"ids": ["7"]}'])


def test_a_folder_of_another_container_says_nothing() -> None:
    with wanted() as here:
        assert here()
    assert not here()
    node, device, place = known(here.path.parent) or ("", 0, 0)
    assert dataclasses.replace(here, folder=(node, device, place + 1))()


def test_what_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "there").mkdir()
    with pytest.raises(OSError, match="there"):
        Files(tmp_path, make=True).write("there", b"x")
    assert os.listdir(tmp_path) == ["there"]


@pytest.mark.parametrize(("ordered", "read"), [(True, [0]), (False, [0, 2, 3, 4])])
def test_what_a_study_has_is_read_as_it_is_taken(
    tmp_path: Path, ordered: bool, read: list[int]
) -> None:
    records = Records(tmp_path, "1.0.0")
    jobs = small(30)
    for job in jobs[:1] + jobs[2:]:
        report = {"status": "converged", "version": "1.0.0", "steps": []}
        records.put(Outcome(brinell.document(job), "", report))
    course = Course(jobs, ordered=ordered, in_flight=4, records=records)
    first = course.take()
    assert [place for place, *_ in course.answers()] == read
    assert [task.place for task in first] == [1]


def test_what_is_no_job_does_not_stop_the_others(client: Client, tmp_path: Path) -> None:
    (tmp_path / "text.json").write_text("{")
    bad: list[Any] = [tmp_path / "none.json", tmp_path / "text.json", {"load": {1, 2}}, None]
    *_, (_, last) = pairs = list(client.map([*bad, *small(1)], ordered=True))
    assert [type(result.error) for _, result in pairs[:4]] == [brinell.InvalidJob] * 4
    assert "none.json" in str(pairs[0][1].error)
    assert last.converged


def test_what_fails_by_chance_is_tried_again() -> None:
    course = Course(small(1), ordered=False, in_flight=1, retries=1)
    failed = Outcome({}, "", None, brinell.JobFailed("", "failed", None))
    (task,) = course.take()
    first = task.key
    course.finish(task, failed)
    (task,) = course.take()
    assert task.key != first
    course.finish(task, failed)
    assert course.take() == []
    ((_, _, outcome),) = course.answers()
    assert outcome is failed
    assert course.take() == []
    assert course.over


STUDY = """
import sys, brinell
sys.path.insert(0, sys.argv[2])
from test_many import small
with brinell.Client() as client:
    for job, result in client.map(small(40), study=sys.argv[1], in_flight=4):
        print(flush=True)
"""


def test_a_study_goes_on_where_it_was_killed(tmp_path: Path, client: Client) -> None:
    folder = tmp_path / "study"
    script = subprocess.Popen(
        [sys.executable, "-c", STUDY, folder, Path(__file__).parent], stdout=subprocess.PIPE
    )
    assert script.stdout is not None
    for _ in range(20):
        assert script.stdout.readline()
    script.kill()
    script.wait()
    before = set(os.listdir(folder))
    kept = [name for name in before if name.endswith(".jsonl")]
    assert 20 <= len(kept) < 40
    times = {name: (folder / name).stat().st_mtime_ns for name in kept}
    jobs = small(40)
    assert len(list(client.map(jobs, study=folder))) == 40
    after = [name for name in os.listdir(folder) if name.endswith(".jsonl")]
    assert len(after) == 40
    assert all((folder / name).stat().st_mtime_ns == when for name, when in times.items())
    study = brinell.open_study(folder)
    assert len(study) == 40
    assert sorted(study.table["/load/force"]) == sorted(np.linspace(100, 600, 40))
    by_force = {result["force"]: result for result in study}
    for job in jobs[::13]:
        report = by_solve(job)
        kept_one = by_force[brinell.Result(report)["force"]]
        assert kept_one.data["steps"][0]["answers"] == report["steps"][0]["answers"]


def test_a_study_keeps_fields_and_is_anywhere(client: Client, tmp_path: Path) -> None:
    pytest.importorskip("fsspec")
    job = small(1, fields=True)[0]
    for address in (f"memory://study-{os.getpid()}", f"file://{tmp_path}"):
        for _ in range(2):
            ((_, result),) = client.map([job], study=address)
            assert result.converged
            assert result.fields().upper is not None
        (kept,) = brinell.open_study(address)
        assert kept.fields().lower is not None
        assert untimed(kept.data) == untimed(result.data)
    assert len(brinell.open_study(tmp_path)) == 1


def test_a_service_solves_a_job_of_a_study_once(tmp_path: Path, client: Client) -> None:
    jobs = small(3, tags={"of": "study"})
    for run in ("one", "other"):
        assert all(result.converged for _, result in client.map(jobs, study=tmp_path / run))
    listed = client._run(client._core.json("GET", "/v1/jobs", params={"tag": "of:study"}))["jobs"]
    assert len(listed) == 3
    # What was cancelled in one run is solved in the next.
    slow = brinell.job(
        roller(), roller(), analysis="plane_strain", force=600, elements_per_half_width=60
    )
    for _ in client.map([*jobs, slow], study=tmp_path / "one"):
        break
    pairs = list(client.map([slow], study=tmp_path / "one"))
    assert pairs[0][1].converged


def test_jobs_of_a_study_that_are_alike_are_solved_once(tmp_path: Path, client: Client) -> None:
    one, other = small(2, tags={"of": "twins"})
    pairs = list(client.map([one, one, other, one], study=tmp_path, ordered=True))
    assert [job for job, _ in pairs] == [one, one, other, one]
    assert len({result.id for _, result in pairs}) == 2
    assert len(brinell.open_study(tmp_path)) == 2


def test_half_a_file_is_solved_again_and_others_are_left(client: Client, tmp_path: Path) -> None:
    (tmp_path / "jobs.jsonl").write_text("{}\n")
    list(client.map(small(2), study=tmp_path))
    study = brinell.open_study(tmp_path)
    assert len(study) == 2
    half = tmp_path / study.names[0]
    half.write_bytes(half.read_bytes()[:20])
    assert study.table["status"].tolist() == ["not whole", "converged"]
    assert "/upper/shape/radius" not in study.table
    with pytest.raises(brinell.BrinellError, match=half.name):
        _ = study[0]
    assert [result.status for result in study[1:]] == ["converged"]
    assert all(result.converged for _, result in client.map(small(2), study=tmp_path))
    assert len(study.table) == 2
    records, kept = Records(tmp_path, study[0].data["version"]), [study.job(0), study.job(1)]
    half.unlink()
    assert [records.get(job) is None for job in kept] == [True, False]


def test_a_key_of_a_study_is_of_one_version(tmp_path: Path) -> None:
    keys = {
        Course(small(1), ordered=False, in_flight=1, records=Records(tmp_path, version))
        .take()[0]
        .key
        for version in ("1.0.0", "1.0.0", "1.1.0")
    }
    assert len(keys) == 2


def test_the_digest_of_a_job_is_that_of_the_program() -> None:
    # The same stands in src/cli/array.rs.
    document = {"b": [1, 2.5, True, None], "a": {"ü": "x", "": False}}
    assert digest_of(document) == "839cc667e7c409e7085e1118abb76a75"
    assert digest_of({"a": {"": False, "ü": "x"}, "b": [1.0, 2.5, True, None]}) == digest_of(
        document
    )


@pytest.mark.parametrize(
    "error",
    [
        brinell.InvalidJob([brinell.Fault("#/load", "missing", "missing")], "no"),
        brinell.JobFailed("7", "failed", {"detail": "no"}),
        brinell.QuotaExceeded(429, {"title": "full"}, 3.0),
        brinell.ServerDied(9, Path("log"), "bye"),
        brinell.StillRunning("not yet"),
    ],
)
def test_errors_cross_processes(error: brinell.BrinellError) -> None:
    copy = pickle.loads(pickle.dumps(error))
    assert type(copy) is type(error)
    assert str(copy) == str(error)
    assert vars(copy) == vars(error)


def test_a_client_says_why_it_stays(client: Client) -> None:
    with pytest.raises(TypeError, match=r"brinell\.map"):
        pickle.dumps(client)
