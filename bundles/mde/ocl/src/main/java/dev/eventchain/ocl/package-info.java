/**
 * Parses, checks and evaluates OCL on any Ecore model with classic Eclipse OCL, and fixes what is
 * in the way of using it headlessly: exact places for all errors, linear parsing, sets that keep
 * their order, extents over the whole resource set, and a reason for every undefined result.
 */
package dev.eventchain.ocl;
