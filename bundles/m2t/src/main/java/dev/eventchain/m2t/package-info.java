/** MOFM2T templates (Acceleo 3 syntax) on any Ecore model, and the one door for output. */
package dev.eventchain.m2t;
