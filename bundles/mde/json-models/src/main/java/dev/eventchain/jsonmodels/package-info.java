/**
 * Conceptual instance models in JSON (paper, Section IV-B) for any Ecore metamodel: reading them as
 * models, their schema, and the comparison of two models. Problems are findings with their place.
 */
package dev.eventchain.jsonmodels;
