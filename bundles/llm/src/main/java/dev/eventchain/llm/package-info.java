/**
 * Opens the language models that a configuration names, and enforces the budget of a run. The only
 * package that depends on all sources of answers.
 */
package dev.eventchain.llm;
