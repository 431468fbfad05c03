/**
 * Agents, one for each task of the workflow, and the loop that checks and repairs answers.
 * Independent of the providers of language models and of the files of a run.
 */
package dev.eventchain.agents;
