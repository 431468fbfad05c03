/**
 * Complete OCL documents on any Ecore model: what invariants and definitions they and the
 * metamodels state, whether a model keeps them, and what is said of an element that does not.
 */
package dev.eventchain.constraints;
