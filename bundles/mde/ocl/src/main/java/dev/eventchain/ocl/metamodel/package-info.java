/**
 * Metamodels for expressions: types by name, OCL in annotations, and the names of elements and
 * values in messages. Independent of expressions.
 */
package dev.eventchain.ocl.metamodel;
