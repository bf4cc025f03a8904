"""A client and the real program."""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pint
import pytest
from conftest import EXAMPLES, roller

import brinell
from brinell import Client
from brinell._plain import document_of

SLOW = {"analysis": "plane_strain", "force": 612.6106, "elements_per_half_width": 100}


def test_the_reference_problem(client: Client, job: Any) -> None:
    result = client.solve(job)
    assert result.converged
    assert result["peak_pressure"] == pytest.approx(1149.7, rel=1e-4)
    assert result["approach"] == pytest.approx(0.017856, rel=1e-4)
    peak = result.row("peak_pressure")
    assert peak.elastic == pytest.approx(1500, rel=1e-4)
    assert 0 < peak.error < 0.02
    assert peak.reason == ""
    assert (result.row("force").error, result.row("force").reason) == (0, "given")
    assert "dent_depth" not in result
    with pytest.raises(KeyError, match=r"'dent_depth'; there are .*peak_pressure"):
        result.row("dent_depth")
    rows = result.rows
    assert rows.loc["peak_pressure", "value"] == result["peak_pressure"]
    typed = {row.name: row.value for row in result.report.steps[0].answers}
    assert typed["peak_pressure"] == result["peak_pressure"]
    again = client.solve(EXAMPLES / "two_cylinders.json")
    assert again["peak_pressure"] == result["peak_pressure"]


def test_what_is_not_in_order_names_every_field(client: Client) -> None:
    job = json.loads((EXAMPLES / "two_cylinders.json").read_text())
    job["upper"]["shape"]["radius"] = -20
    job["lower"]["colour"] = "red"
    with pytest.raises(brinell.InvalidJob) as caught:
        client.solve(job)
    assert {fault.pointer for fault in caught.value.errors} == {
        "#/upper/shape/radius",
        "#/lower/colour",
    }
    with pytest.raises(brinell.InvalidJob):
        client.validate(job)
    assert client.validate(EXAMPLES / "two_cylinders.json")["equations"] > 1000
    with pytest.raises(brinell.NotFound):
        client.job("0197e1f0-0000-7000-8000-000000000000")


def test_a_job_is_followed_and_cancelled(client: Client) -> None:
    slow = client.submit(brinell.job(roller(), roller(), **SLOW))
    assert slow.status in ("queued", "running")
    assert not slow.wait(0.01)
    with pytest.raises(brinell.StillRunning):
        slow.result(0.01)
    slow.cancel()
    assert slow.wait()
    assert slow.status == "cancelled"
    assert client.job(slow.id).done


def test_events_are_told_from_the_first_to_the_last(client: Client, job: Any) -> None:
    events = list(client.submit(job).events())
    iterations = [event.data["iteration"] for event in events if event.kind == "iteration"]
    # Each increment of the load counts its own.
    assert iterations[0] == 1
    assert all(after in (before + 1, 1) for before, after in itertools.pairwise(iterations))
    assert events[-1].kind == "state"
    assert events[-1].data["status"] == "succeeded"
    seen: list[str] = []
    assert client.solve(job, progress=lambda event: seen.append(event.kind)).converged
    assert seen.count("iteration") == len(iterations)
    # A job whose events are left in the middle goes on.
    left = client.submit(job)
    assert len(list(itertools.islice(left.events(), 2))) == 2
    assert left.result().converged


def test_a_bar_counts_iterations(
    client: Client, job: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    client.solve(job, progress=True)
    assert "iterations" in capsys.readouterr().err


def test_many_jobs_come_in_their_order_and_what_fails_is_a_value(client: Client) -> None:
    jobs: list[Any] = [
        brinell.job(
            roller(), roller(), analysis="plane_strain", force=force, elements_per_half_width=6
        )
        for force in np.linspace(100, 600, 150)
    ]
    jobs[3] = {"analysis": "plane_strain"}
    jobs[5] = brinell.job(
        roller(), roller(), analysis="plane_strain", force=600, solver={"max_iterations": 1}
    )
    pairs = list(client.map(iter(jobs), in_flight=40, ordered=True))
    assert [job for job, _ in pairs] == jobs
    results = [result for _, result in pairs]
    assert results[3].status == "invalid"
    assert isinstance(results[3].error, brinell.InvalidJob)
    with pytest.raises(brinell.InvalidJob):
        _ = results[3]["peak_pressure"]
    assert results[5].status == "not_converged"
    good = [result for place, result in enumerate(results) if place not in (3, 5)]
    assert all(result.converged for result in good)
    forces = [result["force"] for result in good]
    assert forces == sorted(forces)
    unordered = list(client.map(jobs[:20], progress=True))
    assert sorted(str(job) for job, _ in unordered) == sorted(str(job) for job in jobs[:20])


def test_jobs_that_are_too_long_together_go_in_parts() -> None:
    # A measured curve of many points: a job is far below the 1 MiB of a request, all are above.
    strain = np.linspace(0, 0.1, 3000)
    law = brinell.table(points=np.column_stack([strain, 400 + 300 * strain**0.3]))
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    body = brinell.cylinder(radius=20, material=steel)
    jobs = [
        brinell.job(body, body, analysis="plane_strain", force=f, elements_per_half_width=6)
        for f in np.linspace(100, 200, 12)
    ]
    assert sum(len(json.dumps(document_of(job))) for job in jobs) > 1 << 20
    # One that is too long by itself does not stop the others.
    big = {**document_of(jobs[0]), "tags": {"long": "x" * (1 << 20)}}
    with Client(max_body=1 << 20) as client:
        assert all(result.converged for _, result in client.map(jobs))
        (_, good), (_, bad) = client.map([jobs[0], big], ordered=True)
    assert good.converged
    assert isinstance(bad.error, brinell.ServiceError)
    assert bad.error.status == 413


def test_one_job_or_one_value_where_many_are_wanted_says_so(client: Client, job: Any) -> None:
    for one in (job, document_of(job), EXAMPLES / "two_cylinders.json"):
        with pytest.raises(TypeError, match="several jobs"):
            next(client.map(one))
    for values in (100, "S355"):
        with pytest.raises(TypeError, match="/load/force"):
            client.sweep(job, {"/load/force": values})  # type: ignore[dict-item]


def test_jobs_of_a_map_that_is_left_are_cancelled(client: Client) -> None:
    jobs = [brinell.job(roller(500 + k), roller(), **SLOW, tags={"left": "yes"}) for k in range(6)]
    first = brinell.job(roller(), roller(), analysis="plane_strain", force=100)
    for _ in client.map([first, *jobs], ordered=False):
        break
    listed = client._run(client._core.json("GET", "/v1/jobs", params={"tag": "left:yes"}))["jobs"]
    assert len(listed) == 6
    assert all(client.job(one["id"]).wait(60) for one in listed)
    assert {client.job(one["id"]).status for one in listed} == {"cancelled"}


def test_a_sweep_is_a_table(client: Client, job: Any) -> None:
    table = client.sweep(
        job,
        {
            "/load/force": np.array([300.0, 600.0]),
            (
                "#/upper/material/plasticity/yield_stress",
                "/lower/material/plasticity/yield_stress",
            ): [400, 500],
        },
    )
    assert table.columns[:2].tolist() == [
        "/load/force",
        "#/upper/material/plasticity/yield_stress",
    ]
    assert table["/load/force"].tolist() == [300.0, 300.0, 600.0, 600.0]
    assert (table["status"] == "converged").all()
    alone = brinell.job(roller(), roller(), analysis="plane_strain", force=600)
    assert table["peak_pressure"].iloc[3] == client.solve(alone)["peak_pressure"]
    assert table["peak_pressure"].iloc[2] < table["peak_pressure"].iloc[3]

    def at(force: float, radius: float) -> Any:
        body = brinell.cylinder(radius=20, material=brinell.steels["S355"])
        upper = {
            "shape": {"type": "cylinder", "radius": radius},
            "material": brinell.steels["S355"],
        }
        return brinell.job(upper, body, analysis="plane_strain", force=force) if radius > 0 else {}

    table = client.sweep(at, {"force": [200.1], "radius": [10, -1]})
    assert table["force"].tolist() == [200.1, 200.1]
    assert table["status"].tolist() == ["converged", "invalid"]
    assert np.isnan(table["peak_pressure"].iloc[1])
    assert "analysis" in table["error"].iloc[1]
    steels = client.sweep(job, {("/upper/material", "/lower/material"): ["S235", "S355"]})
    assert steels["/upper/material"].tolist() == ["S235", "S355"]
    assert steels["peak_pressure"].is_monotonic_increasing
    with pytest.raises(brinell.InvalidJob, match="/load/forc"):
        client.sweep(job, {"/load/forc": [1, 2]})


def test_the_same_by_awaiting(job: Any) -> None:
    async def use() -> None:
        async with brinell.AsyncClient() as client:
            result = await client.solve(job)
            assert result["peak_pressure"] == pytest.approx(1149.7, rel=1e-4)
            handle = await client.submit(job)
            kinds = [event.kind async for event in handle.events()]
            assert kinds[-1] == "state"
            assert "iteration" in kinds
            assert (await handle.refresh()).status == "succeeded"
            assert (await handle.result()).converged
            pairs = [pair async for pair in client.map([job, job])]
            assert [result.converged for _, result in pairs] == [True, True]
            table = await client.sweep(job, {"/load/force": [100, 200]})
            assert (table["status"] == "converged").all()
            slow = asyncio.create_task(
                client.solve(brinell.job(roller(), roller(), **SLOW, tags={"slow": "yes"}))
            )
            mine = {"tag": "slow:yes"}
            while not (
                listed := (await client._run(client._core.json("GET", "/v1/jobs", params=mine)))[
                    "jobs"
                ]
            ):
                pass
            slow.cancel()
            with pytest.raises(asyncio.CancelledError):
                await slow
            stopped = await client.job(listed[0]["id"])
            assert await stopped.wait(60)
            assert stopped.status == "cancelled"
            with_fields = await client.solve(
                brinell.job(roller(), roller(), analysis="plane_strain", force=600, fields=True)
            )
            with pytest.raises(RuntimeError):
                with_fields.fields()
            await with_fields.fetch_fields()
            assert with_fields.fields().upper is not None

    asyncio.run(use())


def test_an_answer_that_is_lost_is_asked_for_again(
    client: Client, job: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    import httpx

    before = len(
        client._run(client._core.json("GET", "/v1/jobs", params={"limit": "100"}))["jobs"]
    )
    http = client._client()
    real, sent = http.request, []

    def lossy(**options: Any) -> httpx.Response:
        response = real(**options)
        if options["method"] == "POST":
            sent.append(options["headers"]["Idempotency-Key"])
            if len(sent) == 1:
                raise httpx.ReadError("the line was cut")
        return response

    monkeypatch.setattr(http, "request", lossy)
    monkeypatch.setattr("brinell._core.PAUSE", 0.01)
    tagged = {
        **json.loads((EXAMPLES / "two_cylinders.json").read_text()),
        "tags": {"lost": "once"},
    }
    assert client.submit(tagged).result().converged
    assert len(sent) == 2
    assert sent[0] == sent[1]
    jobs = client._run(client._core.json("GET", "/v1/jobs", params={"tag": "lost:once"}))["jobs"]
    assert len(jobs) == 1, before


def test_what_passes_is_tried_again_and_what_does_not_is_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    import httpx

    from brinell._core import Send, Sleep, call

    def ask(*answers: httpx.Response | Exception, retries: int = 2) -> tuple[Any, list[float]]:
        flow = call(retries, "POST", "/v1/jobs", body={})
        pauses: list[float] = []
        effect = next(flow)
        given = iter(answers)
        try:
            while True:
                if isinstance(effect, Sleep):
                    pauses.append(effect.seconds)
                    effect = flow.send(None)
                    continue
                assert isinstance(effect, Send)
                answer = next(given)
                effect = flow.throw(answer) if isinstance(answer, Exception) else flow.send(answer)
        except StopIteration as end:
            return end.value, pauses
        except brinell.BrinellError as error:
            return error, pauses

    busy = httpx.Response(
        429, headers={"Retry-After": "3"}, json={"type": "/problems/queue-full", "title": "full"}
    )
    good = httpx.Response(202, json={})
    answer, pauses = ask(busy, good)
    assert answer is good
    assert 3.0 <= pauses[0] <= 6.0
    answer, pauses = ask(httpx.ConnectError("refused"), httpx.Response(503, json={}), good)
    assert answer is good
    assert 0.2 <= pauses[0] <= 0.4 <= pauses[1] <= 0.8
    error, pauses = ask(busy, busy, busy)
    assert isinstance(error, brinell.QuotaExceeded)
    assert (error.retry_after, error.kind, len(pauses)) == (3.0, "queue-full", 2)
    error, pauses = ask(*[httpx.ConnectError("refused")] * 3)
    assert isinstance(error, brinell.Unavailable)
    for status in (400, 401, 404, 422):
        error, pauses = ask(httpx.Response(status, json={"title": "no"}))
        assert isinstance(error, brinell.BrinellError)
        assert pauses == []


# The local server.


def test_a_server_that_dies_is_an_exception_that_names_its_log(job: Any) -> None:
    with Client() as client:
        assert client._server is not None
        os.kill(client._server.pid, signal.SIGKILL)
        with pytest.raises(brinell.ServerDied) as caught:
            client.solve(job)
        assert caught.value.exit_code == -signal.SIGKILL
        assert caught.value.log.exists()
        assert str(caught.value.log) in str(caught.value)
        caught.value.log.unlink()


def test_a_server_that_does_not_start_says_why(tmp_path: Path) -> None:
    program = tmp_path / "brinell"
    program.write_text("#!/bin/sh\necho 'error: no memory' >&2\nexit 3\n")
    program.chmod(0o755)
    with pytest.raises(brinell.ServerDied, match="no memory") as caught:
        Client(program=program)
    assert caught.value.exit_code == 3
    caught.value.log.unlink()


def test_without_a_program_one_is_told_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("BRINELL_PROGRAM")
    monkeypatch.setenv("PATH", "/nonexistent")
    monkeypatch.setitem(sys.modules, "brinell_server", None)
    with pytest.raises(brinell.ServerNotFound, match="BRINELL_PROGRAM"):
        Client()


def test_the_key_is_the_only_one_and_a_url_needs_it(client: Client, job: Any) -> None:
    with Client(client.url) as stranger, pytest.raises(brinell.Unauthorized):
        stranger.solve(job)
    assert client._server is not None
    with Client(client.url, api_key=client._server.key) as friend:
        assert friend.solve(job).converged


PARENT = """
import os, sys, time, brinell
client = brinell.Client()
job = brinell.job(
    brinell.cylinder(radius=20, material=brinell.steels["S355"]),
    brinell.cylinder(radius=20, material=brinell.steels["S355"]),
    analysis="plane_strain", force=600, elements_per_half_width=160)
client.submit(job)
print(client._server.pid, flush=True)
if "forks" in sys.argv and os.fork() == 0:
    time.sleep(60)
sys.stdin.read()
"""


def gone(pid: int) -> bool:
    """Whether no such process runs: it has been waited for, or waits for it."""
    try:
        stat = Path(f"/proc/{pid}/stat").read_text()
    except FileNotFoundError:
        return True
    return stat.rsplit(")", 1)[1].split()[0] in "ZX"


@pytest.mark.skipif(not Path("/proc").exists(), reason="asks the kernel of Linux")
@pytest.mark.parametrize(
    ("way", "word"),
    [(signal.SIGKILL, ""), (signal.SIGTERM, ""), (None, ""), (signal.SIGKILL, "forks")],
)
def test_the_server_ends_with_its_parent(way: int | None, word: str) -> None:
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT, word],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert parent.stdout is not None
    assert parent.stdin is not None
    pid = int(parent.stdout.readline())
    assert not gone(pid)
    handle = os.pidfd_open(pid)
    if way is None:
        parent.stdin.close()
    else:
        parent.send_signal(way)
    parent.wait(10)
    import select

    # Readable as soon as the process has ended.
    ready, _, _ = select.select([handle], [], [], 20)
    os.close(handle)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(parent.pid, signal.SIGKILL)
    assert ready
    assert gone(pid)


CTRL_C = """
import threading, signal, os, brinell, sys
# A program that a shell has put into the background ignores the key.
signal.signal(signal.SIGINT, signal.default_int_handler)
client = brinell.Client()
job = brinell.job(
    brinell.cylinder(radius=20, material=brinell.steels["S355"]),
    brinell.cylinder(radius=20, material=brinell.steels["S355"]),
    analysis="plane_strain", force=600, elements_per_half_width=160, tags={"stopped": "yes"})
def listed():
    return other._run(other._core.json("GET", "/v1/jobs", params={"tag": "stopped:yes"}))["jobs"]
other = brinell.Client(client.url, api_key=client._server.key)
def interrupt():
    while not listed():
        pass
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=interrupt).start()
try:
    client.solve(job, progress=bool(int(sys.argv[1])))
except KeyboardInterrupt:
    stopped = client.job(listed()[0]["id"])
    stopped.wait(60)
    print(stopped.status)
"""


@pytest.mark.parametrize("progress", ["0", "1"])
def test_ctrl_c_cancels_the_job_and_leaves_the_server(progress: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", CTRL_C, progress], capture_output=True, text=True, timeout=60
    )
    assert done.stdout.strip() == "cancelled", done.stderr


def test_a_point_that_is_no_job_is_a_row(client: Client, job: Any) -> None:
    grids: list[tuple[Any, dict[Any, Any]]] = [
        (job, {"/load/force": [300, float("nan"), -1]}),
        (
            lambda force: brinell.job(roller(), roller(), analysis="plane_strain", force=force),
            {"force": [300, float("nan"), -1]},
        ),
        (job, {("/upper/material", "/lower/material"): ["S355", "butter"]}),
    ]
    for made, grid in grids:
        table = client.sweep(made, grid)
        assert table["status"].tolist() == ["converged", *["invalid"] * (len(table) - 1)]
        assert all(table["error"].iloc[1:])
    assert "butter" in table["error"].iloc[1]


def test_a_figure_that_json_does_not_know_is_named(client: Client, job: Any) -> None:
    document = {**job.model_dump(mode="json", exclude_none=True), "load": {"force": float("inf")}}
    with pytest.raises(brinell.InvalidJob) as refused:
        client.solve(document)
    assert [fault.pointer for fault in refused.value.errors] == ["#/load/force"]


def test_a_map_of_nothing_at_a_time_is_refused(client: Client, job: Any) -> None:
    with pytest.raises(ValueError, match="in_flight"):
        list(client.map([job], in_flight=0))


def test_a_closed_client_says_so(job: Any) -> None:
    with brinell.Client() as client:
        pass
    with pytest.raises(brinell.BrinellError, match="closed"):
        client.solve(job)


def test_a_number_is_found_for_a_figure(client: Client, job: Any) -> None:
    both = ("/upper/shape/radius", "/lower/shape/radius")
    result = client.find(job, both, "peak_pressure", 1100.0)
    found = result.found
    assert result["peak_pressure"] == pytest.approx(1100, rel=2e-3)
    assert 3 <= len(found) <= 8
    assert found.attrs["values"][0] in set(found["value"])
    assert "peak pressure is 1100" in found.attrs["text"].lower()
    # What no value gives is said, not made up.
    with pytest.raises(brinell.InvalidJob, match="nowhere"):
        client.find(job, both, "peak_pressure", 1e6)
    with pytest.raises(ValueError, match="no number above 0"):
        client.find(job, "/upper/shape/type", "peak_pressure", 1.0)
    with pytest.raises(brinell.InvalidJob, match="peek"):
        client.find(job, both, "peek", 1.0)


def test_tolerances_are_a_table(client: Client, job: Any) -> None:
    radius = "/upper/shape/radius"
    table = client.solve({**job_of(job), "tolerances": {radius: 0.05}}).tolerances
    peak = table[table["name"] == "peak_pressure"].iloc[0]
    # The worse one of both senses is not less than their mean.
    assert 1.0 <= peak["at_worst"] / (0.05 * abs(peak[radius])) <= 1.1
    assert radius in table.attrs["text"]


def job_of(job: Any) -> dict[str, Any]:
    return job if isinstance(job, dict) else job.model_dump(exclude_none=True)


def test_a_sweep_takes_quantities(client: Client, job: Any) -> None:
    forces = np.array([0.3, 0.5]) * pint.UnitRegistry()("kN/mm")
    table = client.sweep(job, {"/load/force": forces})
    assert table["/load/force"].tolist() == pytest.approx([300, 500])
    assert table["force"].tolist() == pytest.approx([300, 500])


@pytest.mark.parametrize("variable", ["HTTP_PROXY", "ALL_PROXY"])
def test_a_proxy_is_named_or_gone_around(
    client: Client, job: Any, monkeypatch: pytest.MonkeyPatch, variable: str
) -> None:
    monkeypatch.setenv(variable, "http://user:secret@127.0.0.1:9")
    monkeypatch.delenv("NO_PROXY", raising=False)
    assert client._server is not None
    with Client(client.url, api_key=client._server.key) as named:
        assert named.solve(job).converged
    with (
        Client("http://contact.example", max_retries=0) as far,
        pytest.raises(brinell.Unavailable, match=r"proxy http://127\.0\.0\.1:9.*NO_PROXY") as said,
    ):
        far.solve(job)
    assert "secret" not in str(said.value)


def test_jobs_are_listed(client: Client) -> None:
    jobs = [
        brinell.job(
            roller(), roller(), analysis="plane_strain", force=force, tags={"listed": "yes"}
        )
        for force in (100, 200)
    ]
    handles = [client.submit(job) for job in jobs]
    assert all(handle.wait() for handle in handles)
    listed = list(client.jobs(status="succeeded", tags={"listed": "yes"}))
    assert [one.id for one in listed] == [one.id for one in reversed(handles)]
    assert listed[0].result().converged


def test_a_sweep_is_a_data_set_over_its_grid(client: Client, job: Any) -> None:
    both = ("/upper/shape/radius", "/lower/shape/radius")
    table = client.sweep(job, {"/load/force": [100, 200], both: [10, 20, 30]})
    grid = brinell.over_grid(table)
    assert dict(grid.sizes) == {"force": 2, "radius": 3}
    row = table[(table["/load/force"] == 200) & (table[both[0]] == 30)].iloc[0]
    assert grid["peak_pressure"].sel(force=200, radius=30) == row["peak_pressure"]
    two = client.sweep(job, {both[0]: [10], both[1]: [10, 20]})
    assert set(brinell.over_grid(two).sizes) == set(both)
    with pytest.raises(ValueError, match="sweep"):
        brinell.over_grid(pd.DataFrame({"force": [1]}))
