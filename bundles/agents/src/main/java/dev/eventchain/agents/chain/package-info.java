/**
 * Chain descriptions as written by language models, and the checks of a designed chain. Independent
 * of prompts and models.
 */
package dev.eventchain.agents.chain;
