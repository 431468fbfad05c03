/**
 * The stages that ask language models for the chain, its components, its model and its constraints,
 * and the way back of a failed verdict. Does not know what is generated or simulated from the
 * answers.
 */
package dev.eventchain.pipeline.design;
