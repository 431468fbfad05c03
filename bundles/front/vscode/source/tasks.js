"use strict";
// Commands of the program in a terminal, as tasks: VS Code finds the findings in what they print.

const vscode = require("vscode");
const { nameOf, projects } = require("./projects");

const TYPE = "eventchain";
const MATCHERS = ["$eventchain", "$eventchain-file"];
const COMMANDS = ["validate", "generate", "simulate", "run"];

/**
 * @callback Program
 * @returns {Promise<{command: string, script: string, env: NodeJS.ProcessEnv} | undefined>}
 */

/**
 * Returns a task; its definition is what a tasks.json holds.
 *
 * @param {{type: string, command: string, project?: string, arguments?: string[]}} definition
 * @param {{command: string, script: string, env: NodeJS.ProcessEnv}} program
 * @param {vscode.WorkspaceFolder | vscode.TaskScope} scope
 * @param {string[]} matchers
 */
function task(definition, program, scope, matchers = MATCHERS) {
  const { command, project, arguments: more = [] } = definition;
  const words = [program.script, command, ...(project ? [project] : []), ...more];
  const env = /** @type {{[name: string]: string}} */ (program.env);
  const made = new vscode.Task(
    definition,
    scope,
    [command, ...(project ? [nameOf(project)] : []), ...more].join(" "),
    TYPE,
    new vscode.ProcessExecution(program.command, words, { env }),
    matchers,
  );
  made.presentationOptions = { panel: vscode.TaskPanelKind.Dedicated, clear: true };
  return made;
}

/**
 * Runs a command for a project.
 *
 * @param {Program} find
 * @param {boolean} known whether the language server shows what the command finds
 * @param {string} command
 * @param {string | undefined} project
 * @param {string[]} more
 */
async function runTask(find, known, command, project, ...more) {
  const program = await find();
  if (program) {
    const scope = (project && vscode.workspace.getWorkspaceFolder(vscode.Uri.file(project))) || vscode.TaskScope.Workspace;
    await vscode.workspace.saveAll(false);
    const matchers = known ? [] : MATCHERS;
    await vscode.tasks.executeTask(task({ type: TYPE, command, project, arguments: more }, program, scope, matchers));
  }
}

/** @param {Program} find */
function registerTasks(find) {
  return vscode.tasks.registerTaskProvider(TYPE, {
    async provideTasks() {
      const program = await find();
      return program
        ? (await projects()).flatMap((project) =>
            COMMANDS.map((command) =>
              task(
                { type: TYPE, command, project },
                program,
                vscode.workspace.getWorkspaceFolder(vscode.Uri.file(project)) || vscode.TaskScope.Workspace,
              ),
            ),
          )
        : [];
    },
    async resolveTask(given) {
      const program = await find();
      const definition = /** @type {any} */ (given.definition);
      return program && task(definition, program, given.scope || vscode.TaskScope.Workspace);
    },
  });
}

module.exports = { COMMANDS, registerTasks, runTask };
