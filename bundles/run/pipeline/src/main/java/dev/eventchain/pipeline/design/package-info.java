/**
 * The stages that ask language models for the chain, its components, its model and its constraints,
 * and corrections after a failed verdict. Depends on neither generation nor simulation.
 */
package dev.eventchain.pipeline.design;
