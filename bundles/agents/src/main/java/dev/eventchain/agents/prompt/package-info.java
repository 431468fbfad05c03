/**
 * The texts of prompts and the schemas of answers. Does not know who is asked, nor how answers are
 * checked.
 */
package dev.eventchain.agents.prompt;
