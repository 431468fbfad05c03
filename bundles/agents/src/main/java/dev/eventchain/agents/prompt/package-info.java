/**
 * The texts of prompts and the schemas of answers. Independent of the model that is asked and of
 * the checks of answers.
 */
package dev.eventchain.agents.prompt;
