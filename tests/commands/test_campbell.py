def test_critical_speeds_of_the_present_coupling(run, quick):
    code, out, err = run("campbell", quick)
    assert (code, err) == (0, "")
    assert "Critical speeds" in out
    assert "Present coupling" in out


def test_with_another_value(run, quick):
    before = run("campbell", quick)[1]
    code, after, _ = run(
        "campbell", quick, "--set", "coupling.torsional_stiffness=8 kN*m/rad"
    )
    assert code == 0
    assert before != after
