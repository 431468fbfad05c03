"""Mends a project by the tools of `eventchain mcp` alone: python mend.py MODE PROJECT FILE OLD NEW COMMAND...

Prints one line for each thing that it has learnt.
"""

import asyncio
import sys

from mcp import Client, StdioServerParameters


async def call(client, name, **arguments):
    """Return a tool's structured content, and how many messages about its progress came."""
    messages = []

    async def progress(_done, _total, message):
        messages.append(message)

    result = await client.call_tool(name, arguments, progress_callback=progress)
    if result.is_error:
        raise SystemExit(f"{name}: {result.content[0].text}")
    return result.structured_content, len(messages)


async def mend(client, project, file, old, new):
    """Run, find out why it fails, try a change, make it, and run again."""
    tools = (await client.list_tools()).tools
    print("tools", len(tools), "prompts", len((await client.list_prompts()).prompts))
    first, progress = await call(client, "run", project=project)
    print("verdict", first["verdict"], "progress", progress > 3)
    failed, _ = await call(
        client,
        "query",
        project=project,
        table="criteria",
        where=[{"column": "passed", "equals": False}],
        orderBy="margin.value",
        limit=1,
    )
    worst = failed["rows"][0]
    print("failed", worst["scenario"], worst["text"])
    signals, _ = await call(
        client,
        "signals",
        project=project,
        scenario=worst["scenario"],
        time=worst["margin.time"],
        signals=["gap", "brake"],
    )
    print("signals", len(signals["rows"]) > 5)
    text = (await client.read_resource(f"eventchain://files/{project}/{file}")).contents[0].text
    print("reads", old in text)
    edits = [{"file": file, "old": old, "new": new}]
    proposal, _ = await call(client, "propose", project=project, edits=edits, check="run")
    print("proposed", proposal["verdict"], "judges", proposal["judges"])
    applied, _ = await call(client, "apply", proposal=proposal["proposal"])
    print("applied", applied["files"])
    stale, _ = await call(client, "results", project=project)
    print("changed", stale["changedSince"])
    last, _ = await call(client, "run", project=project)
    print("verdict", last["verdict"], "exit", last["exitCode"])


async def main():
    """Connect by the mode that is asked for."""
    mode, project, file, old, new, *command = sys.argv[1:]
    server = StdioServerParameters(command=command[0], args=command[1:])
    async with Client(server, mode=mode) as client:
        print("protocol", client.protocol_version)
        await mend(client, project, file, old, new)


asyncio.run(main())
