/**
 * Conceptual instance models in JSON (paper, Section IV-B) for any Ecore metamodel: read to models,
 * the schema for them, and the comparison of two models. Problems are findings with their place.
 */
package dev.eventchain.jsonmodels;
