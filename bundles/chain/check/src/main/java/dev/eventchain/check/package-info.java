/**
 * Checks of models and of the chain of a project, and their findings. The package reads files but
 * runs no stage: no language model, no generation, no simulation. So editors use the same checks as
 * the command line.
 */
package dev.eventchain.check;
