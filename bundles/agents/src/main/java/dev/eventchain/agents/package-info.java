/**
 * The paper's workflow (Sections III to V): one agent for each task that a language model does,
 * each with its prompt, the checks of its answers, and a loop that sends findings back to the
 * model.
 */
package dev.eventchain.agents;
