"""Small results written by hand, for the tests of the command line."""

from subdiv_cli.model import Finding, Problem, Result, Verdict
from subdiv_cli.model.findings import CONVERGENCE

FINDING = Finding(
    code="SD201", name="convergence", verdict=Verdict.PROVED, statement="‖½S_1‖∞ < 1", source="Dyn 3.2",
    answers=((CONVERGENCE, Verdict.PROVED),),
)  # fmt: skip
PROBLEM = Problem(code="SD003", message="fraction not quoted", file="bad.toml", line=1, column=2, source="x=1/2")


def result(status, **more):
    """A result with this status; the file is named after it."""
    problems = (PROBLEM,) if status == "invalid" else ()
    findings = () if status == "invalid" else (FINDING,)
    return Result(
        file=f"{status}.toml", name=f"the {status} mask", status=status, problems=problems, findings=findings, **more
    )
