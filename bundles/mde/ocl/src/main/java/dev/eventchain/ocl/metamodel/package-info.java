/**
 * Metamodels as expressions refer to them: types by name, OCL in annotations, and the names of
 * elements and values in messages. Knows no expression.
 */
package dev.eventchain.ocl.metamodel;
