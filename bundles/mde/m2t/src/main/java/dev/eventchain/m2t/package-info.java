/** MOFM2T templates (Acceleo 3 syntax) on any Ecore model. */
package dev.eventchain.m2t;
