/**
 * Tests of components, and the checks of generated Python code. Depends on the description of the
 * chain, not on prompts.
 */
package dev.eventchain.agents.component;
