/**
 * Evaluations for callers and operation libraries: variables, time budgets, and invalid values.
 * Independent of expressions and their nodes.
 */
package dev.eventchain.ocl.evaluation;
