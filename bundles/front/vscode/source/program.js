"use strict";
// Where the program and its Java are, and what is missing.

const { execFile } = require("child_process");
const fs = require("fs");
const path = require("path");

const LEAST_JAVA = 17;

/** What a machine lacks, in words for people. */
class Missing extends Error {}

/**
 * @param {string} name
 * @param {NodeJS.ProcessEnv} env
 */
function onPath(name, env) {
  const folders = (env.PATH || "").split(path.delimiter).filter(Boolean);
  return folders.map((folder) => path.join(folder, name)).find(isProgram);
}

/** @param {string} file */
function isProgram(file) {
  try {
    fs.accessSync(file, fs.constants.X_OK);
    return fs.statSync(file).isFile();
  } catch {
    return false;
  }
}

/**
 * Returns the version of a Java by asking it; 0 if it does not say.
 *
 * @param {string} java
 * @returns {Promise<number>}
 */
function javaVersion(java) {
  return new Promise((resolve) => {
    execFile(java, ["-XshowSettings:properties", "-version"], { timeout: 20_000 }, (error, out, err) => {
      const version = /java\.specification\.version = (?:1\.)?(\d+)/.exec(err + out);
      resolve(error || !version ? 0 : Number(version[1]));
    });
  });
}

/**
 * Returns a Java that the program can run on: the one of the setting, else of JAVA_HOME, else of the PATH.
 *
 * @param {string} setting the folder of a Java, or nothing
 * @param {NodeJS.ProcessEnv} env
 * @param {(java: string) => Promise<number>} version
 */
async function findJava(setting, env, version = javaVersion) {
  const home = setting || env.JAVA_HOME;
  const inHome = home && path.join(home, "bin", "java");
  if (setting && !isProgram(/** @type {string} */ (inHome))) {
    throw new Missing(`The setting eventchain.java.home is ${setting}, but there is no bin/java in it.`);
  }
  const java = inHome && isProgram(inHome) ? inHome : onPath("java", env);
  if (!java) {
    throw new Missing(`There is no Java here. Install version ${LEAST_JAVA} or later, or set eventchain.java.home.`);
  }
  const found = await version(java);
  if (found === 0) {
    throw new Missing(`${java} does not say which Java it is. Set eventchain.java.home to version ${LEAST_JAVA} or later.`);
  }
  if (found < LEAST_JAVA) {
    throw new Missing(`${java} is Java ${found}, which is too old. Install version ${LEAST_JAVA} or later, or set eventchain.java.home.`);
  }
  return java;
}

/**
 * Returns how to start the program with arguments.
 *
 * @param {{program: string, javaHome: string, memory: string}} settings
 * @param {string} bundled the folder of the program inside the extension
 * @param {NodeJS.ProcessEnv} env
 * @param {(java: string) => Promise<number>} [version]
 */
async function findProgram(settings, bundled, env, version) {
  const own = settings.program;
  const script = own || path.join(bundled, "bin", "eventchain");
  if (!fs.existsSync(script)) {
    throw new Missing(
      own
        ? `The setting eventchain.program is ${own}, which is not there.`
        : "This build of the extension does not hold the program. Set eventchain.program to one.",
    );
  }
  const bash = onPath("bash", env);
  if (!bash) {
    throw new Missing("There is no bash here, which starts the program.");
  }
  const java = await findJava(settings.javaHome, env, version);
  const set = { ...env };
  // The start script looks for the same Java; a JAVA_HOME that leads nowhere is of no use to it.
  if (settings.javaHome) {
    set.JAVA_HOME = settings.javaHome;
  }
  if (settings.memory) {
    set.EVENTCHAIN_MEMORY = settings.memory;
  }
  return { java, command: bash, script, env: set };
}

module.exports = { Missing, findJava, findProgram };
