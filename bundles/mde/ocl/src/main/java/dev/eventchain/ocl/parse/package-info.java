/**
 * The parser: the environment and analyzer of Eclipse OCL, calls of libraries, and messages for
 * errors. Independent of evaluation.
 */
package dev.eventchain.ocl.parse;
