/**
 * Values of OCL: numbers, collections, equality, and limits of size. Knows neither models nor
 * expressions.
 */
package dev.eventchain.ocl.values;
