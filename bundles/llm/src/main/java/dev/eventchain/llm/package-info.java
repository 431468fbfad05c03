/**
 * Opens the language models that a configuration names, and keeps to the budget of a run. The only
 * package that knows all the ways to an answer.
 */
package dev.eventchain.llm;
