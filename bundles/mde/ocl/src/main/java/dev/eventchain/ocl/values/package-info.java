/**
 * Values of OCL: numbers, collections, equality, and limits of size. Independent of models and
 * expressions.
 */
package dev.eventchain.ocl.values;
