/**
 * One agent for each task of the workflow, and the loop that has answers checked and repaired.
 * Knows no provider of language models and no files of a run.
 */
package dev.eventchain.agents;
