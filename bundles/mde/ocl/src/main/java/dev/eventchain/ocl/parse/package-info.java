/**
 * The parser: the environment and analyzer of Eclipse OCL, calls of libraries, and messages for
 * errors. Evaluates nothing.
 */
package dev.eventchain.ocl.parse;
