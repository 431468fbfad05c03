/**
 * Validation of models of any Ecore metamodel by Complete OCL documents: invariants and definitions
 * of documents and metamodels, their evaluation, and the findings.
 */
package dev.eventchain.constraints;
