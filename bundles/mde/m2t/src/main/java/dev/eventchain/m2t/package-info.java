/** Template modules in MOFM2T (Acceleo 3 syntax) on any Ecore model: compiling and running them. */
package dev.eventchain.m2t;
