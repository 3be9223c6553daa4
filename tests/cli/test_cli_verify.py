"""`subdiv verify` as a user runs it: certificates of real masks, forged ones, other masks, files that are none."""

import json
from pathlib import Path

import pytest
from support import subdiv

ROOT = Path(__file__).parents[2]
SCALAR = ROOT / "masks" / "scalar"


@pytest.fixture(scope="module")
def proofs(tmp_path_factory):
    """Certificates of some shipped masks, as `check --certificate` writes them."""
    directory = tmp_path_factory.mktemp("proofs")
    masks = [SCALAR / name for name in ("four_point.toml", "bspline_degree_2.toml", "ternary_four_point.toml")]
    run = subdiv("check", *masks, SCALAR / "counterexamples" / "chaikin_in_z3.toml", "--certificate", directory)
    assert run.returncode == 0, run.stderr
    return directory


def test_a_directory_of_certificates(proofs):
    run = subdiv("verify", proofs)
    assert run.returncode == 0
    *lines, summary = run.stdout.splitlines()
    assert summary == "4 certificates: 4 VERIFIED"
    assert [Path(line.split(": ")[0]).stem for line in lines] == [
        "bspline_degree_2",
        "chaikin_in_z3",
        "four_point",
        "ternary_four_point",
    ]
    assert all(": VERIFIED " in line for line in lines)


def test_one_certificate_has_no_prefix(proofs):
    run = subdiv("verify", proofs / "four_point.json")
    assert run.returncode == 0
    assert run.stdout.startswith("VERIFIED ")
    assert run.stdout.count("\n") == 1


def test_the_mask_is_compared(proofs):
    proof = proofs / "four_point.json"
    same = subdiv("verify", proof, "--mask", SCALAR / "four_point.toml")
    assert (same.returncode, same.stdout.startswith("VERIFIED ")) == (0, True)
    other = subdiv("verify", proof, "--mask", SCALAR / "four_point.toml", "-p", "w=1/17")
    assert other.returncode == 1
    assert other.stdout.startswith("NOT VERIFIED mask: the certificate is about another mask")
    assert subdiv("verify", proof, "--mask", proofs / "none.toml").returncode == 2


def test_a_plain_mask_file_is_read_by_the_checker_itself(proofs, tmp_path):
    proof, plain, long = proofs / "bspline_degree_2.json", tmp_path / "plain.toml", tmp_path / "long.toml"
    plain.write_text('[mask]\nstart = -2\ncoefficients = [0, "1/4", 0.75, "3/4", "0.25", 0]\n', encoding="utf-8")
    long.write_text('[mask]\nsymbol = "z^-1 (1+z)^3/4"\n', encoding="utf-8")
    for mask, how in ((plain, f"(the mask of {plain})"), (long, "its parameters and symbol expanded by subdiv)")):
        run = subdiv("verify", proof, "--mask", mask)
        assert run.returncode == 0
        assert run.stdout.rstrip().endswith(how)


def test_a_forged_number_is_found(proofs, tmp_path):
    document = json.loads((proofs / "four_point.json").read_text(encoding="utf-8"))
    (claim,) = (c for c in document["claims"] if c["rule"] == "norm" and c["statement"]["nu"] == 2)
    claim["statement"]["norm"] = "1/2"
    forged = tmp_path / "forged.json"
    forged.write_text(json.dumps(document), encoding="utf-8")
    run = subdiv("verify", proofs / "four_point.json", forged)
    assert run.returncode == 1
    good, bad, summary = run.stdout.splitlines()
    assert summary == "2 certificates: 1 VERIFIED, 1 NOT VERIFIED"
    assert ": VERIFIED " in good
    assert ": NOT VERIFIED " in bad


@pytest.fixture
def mixed(proofs, tmp_path):
    """Four good certificates, and one that is none."""
    for proof in proofs.iterdir():
        (tmp_path / proof.name).write_bytes(proof.read_bytes())
    (tmp_path / "empty.json").write_text("{}", encoding="utf-8")
    return tmp_path


def test_quiet(proofs, mixed):
    assert (subdiv("verify", proofs, "-q").returncode, subdiv("verify", proofs, "-q").stdout) == (0, "")
    run = subdiv("verify", mixed, "-q")
    bad, summary = run.stdout.splitlines()
    assert run.returncode == 1
    assert bad.startswith(f"{mixed / 'empty.json'}: NOT VERIFIED document: ")
    assert summary == "5 certificates: 4 VERIFIED, 1 NOT VERIFIED"


def test_json(mixed):
    run = subdiv("verify", mixed, mixed / "none.json", "--format", "json")
    report = json.loads(run.stdout)
    assert run.returncode == 2
    assert "none.json cannot be read" in run.stderr
    assert (report["format"], report["version"]) == ("subdiv-verify", 1)
    assert report["summary"] == {"certificates": 6, "verified": 4, "not_verified": 1, "unreadable": 1}
    statuses = {Path(result["file"]).stem: result["status"] for result in report["results"]}
    assert (statuses["empty"], statuses["none"], statuses["four_point"]) == ("not_verified", "unreadable", "verified")
    assert all(set(result) == {"file", "status", "line", "claim"} for result in report["results"])
    forged = json.loads((mixed / "four_point.json").read_text(encoding="utf-8"))
    (number,) = (n for n, c in enumerate(forged["claims"]) if c["rule"] == "norm" and c["statement"]["nu"] == 2)
    forged["claims"][number]["statement"]["norm"] = "1/2"
    (mixed / "forged.json").write_text(json.dumps(forged), encoding="utf-8")
    (result,) = json.loads(subdiv("verify", mixed / "forged.json", "--format", "json").stdout)["results"]
    assert (result["status"], result["claim"]) == ("not_verified", number)


def test_several_processes_say_the_same_in_the_same_order(mixed):
    for proof in [*mixed.iterdir()]:
        for copy in range(4):
            (mixed / f"{copy}-{proof.name}").write_bytes(proof.read_bytes())
    one, two = (subdiv("verify", mixed, "--jobs", jobs) for jobs in (1, 2))
    assert (one.stdout, one.returncode) == (two.stdout, two.returncode)
    assert two.stdout.endswith("\n25 certificates: 20 VERIFIED, 5 NOT VERIFIED\n")


def test_what_is_no_certificate(proofs, tmp_path):
    missing = subdiv("verify", tmp_path / "none.json", proofs / "four_point.json")
    assert missing.returncode == 2
    assert "none.json cannot be read" in missing.stderr
    assert "VERIFIED" in missing.stdout
    (tmp_path / "empty.json").write_text("", encoding="utf-8")
    (tmp_path / "latin.json").write_bytes(b"\xff\xfe")
    broken = subdiv("verify", tmp_path)
    assert broken.returncode == 1
    assert broken.stdout.count("NOT VERIFIED document") == 2
    assert subdiv("verify").returncode == 2
    (tmp_path / "directory").mkdir()
    assert subdiv("verify", tmp_path / "directory").returncode == 2


def test_a_directory_that_cannot_be_made(tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    run = subdiv("check", SCALAR / "four_point.toml", "--certificate", tmp_path / "file" / "proofs")
    assert run.returncode == 2
    assert "Traceback" not in run.stderr
    assert "certificates cannot be written" in run.stderr


def test_the_report_names_the_proof(tmp_path):
    run = subdiv("check", SCALAR / "bspline_degree_2.toml", "--certificate", "proofs", cwd=tmp_path)
    assert run.returncode == 0
    assert run.stdout.endswith("\nproof: proofs/bspline_degree_2.json\n")


def test_the_proof_is_named_in_one_piece(tmp_path):
    deep = Path("a directory with a long name " * 3, "and another one " * 5)
    run = subdiv("check", SCALAR / "bspline_degree_2.toml", "--certificate", deep, cwd=tmp_path)
    assert run.returncode == 0
    assert run.stdout.splitlines()[-1] == f"proof: {deep / 'bspline_degree_2.json'}"
