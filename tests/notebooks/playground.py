import marimo

app = marimo.App()


@app.cell
def _():
    import marimo as mo
    import parkade
    from parkade.widget import Playground

    playground = mo.ui.anywidget(Playground(planners=["eight", "hybrid"], height=420))
    playground
    return mo, parkade, playground


@app.cell
def _(mo, playground):
    start, results = playground.value["scene"]["start"], playground.value["results"]
    here = {planner: plan.hash for planner, plan in playground.widget.plans().items()}
    same = {planner: result["hash"] == here[planner] for planner, result in results.items()}
    mo.md(f"start at {start['x']:.2f}; same: {same}")
    return


@app.cell
def _(mo):
    parallel = mo.ui.button(label="parallel", value=0, on_click=lambda count: count + 1)
    parallel
    return (parallel,)


@app.cell
def _(parallel, parkade, playground):
    if parallel.value:
        playground.widget.scene = parkade.scenario("parallel")
    return


if __name__ == "__main__":
    app.run()
